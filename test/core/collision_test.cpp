#include "atom_mapping/query/collision.h"

#include <gtest/gtest.h>

#include "atom_mapping/base/random.h"
#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr float kRadius = 0.5F;
constexpr float kFree = -1.0F;
constexpr float kOccupied = 1.0F;

void add(AtomMap& map, const Vector3f& center, float value) {
  map.atoms().insert(center, &value);
}

// Tangent atoms of a cubic lattice, occupied from z = 0 down.
AtomMap makeBlock(int half) {
  AtomMap map(Mode::kOccupancy, kRadius);
  for (int x = -half; x <= half; ++x) {
    for (int y = -half; y <= half; ++y) {
      for (int z = -half; z <= half; ++z) add(map, Vector3f(x, y, z), z <= 0 ? kOccupied : kFree);
    }
  }
  return map;
}

TEST(Collision, AnEmptyMapIsUnknownEverywhere) {
  const AtomMap map(Mode::kOccupancy, kRadius);
  EXPECT_TRUE(collides(map, Vector3f::Zero(), 0.0F, false));
  EXPECT_FALSE(collides(map, Vector3f::Zero(), 100.0F, true));
}

TEST(Collision, AnOccupiedAtomAmongFreeOnesCollidesFromItsRimOn) {
  AtomMap map(Mode::kOccupancy, kRadius);
  add(map, Vector3f::Zero(), kOccupied);
  for (int axis = 0; axis < 3; ++axis) {
    add(map, Vector3f::Unit(axis), kFree);
    add(map, -Vector3f::Unit(axis), kFree);
  }
  EXPECT_TRUE(collides(map, Vector3f(1.49F, 0.0F, 0.0F), 1.0F, true));
  EXPECT_FALSE(collides(map, Vector3f(1.51F, 0.0F, 0.0F), 1.0F, true));
  EXPECT_TRUE(collides(map, Vector3f(0.0F, 0.49F, 0.0F), 0.0F, true));
  EXPECT_FALSE(collides(map, Vector3f(0.0F, 0.51F, 0.0F), 0.0F, true));
}

TEST(Collision, BesideUnknownSpaceAnOccupiedAtomReachesTwoRadiiAsInEquation5) {
  AtomMap map(Mode::kOccupancy, kRadius);
  add(map, Vector3f::Zero(), kOccupied);
  EXPECT_TRUE(collides(map, Vector3f(1.99F, 0.0F, 0.0F), 1.0F, true));
  EXPECT_FALSE(collides(map, Vector3f(2.01F, 0.0F, 0.0F), 1.0F, true));
}

TEST(Collision, ASmallSphereInASurfaceBetweenItsAtomsCollides) {
  AtomMap map(Mode::kOccupancy, kRadius);
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      add(map, 1.2F * kRadius * Vector3f(2 * x, 2 * y, 0) - kRadius * Vector3f::UnitZ(), kOccupied);
      add(map, 1.2F * kRadius * Vector3f(2 * x, 2 * y, 0) + kRadius * Vector3f::UnitZ(), kFree);
    }
  }
  const Vector3f between(1.2F * kRadius, 1.2F * kRadius, 0.0F);  // overlaps no atom
  EXPECT_TRUE(collides(map, between, 0.1F, true));
  EXPECT_FALSE(collides(map, between + 0.2F * Vector3f::UnitZ(), 0.1F, true));
}

TEST(Collision, FreeAtomsDoNotCollide) {
  AtomMap map(Mode::kOccupancy, kRadius);
  add(map, Vector3f::Zero(), kFree);
  EXPECT_FALSE(collides(map, Vector3f::Zero(), 0.3F, true));
  EXPECT_FALSE(collides(map, Vector3f::Zero(), 0.3F, false));
}

TEST(Collision, ASphereThatReachesOutOfTheMapCollidesUnlessUnknownIsFree) {
  const AtomMap map = makeBlock(6);
  const Vector3f center(0.0F, 0.0F, 4.0F);
  EXPECT_FALSE(collides(map, center, 2.5F, false));
  EXPECT_TRUE(collides(map, center, 3.1F, false));  // its pole lies more than 2r above the highest atoms
  EXPECT_FALSE(collides(map, center, 3.1F, true));
  EXPECT_TRUE(collides(map, center, 3.6F, true));  // touches the occupied half
}

TEST(Collision, AHoleAsWideAsASphereIsFound) {
  AtomMap map = makeBlock(6);
  map.clearRegion({Eigen::Vector3d(-2.1, -2.1, 2.0), Eigen::Vector3d(2.1, 2.1, 5.0)});
  EXPECT_TRUE(collides(map, Vector3f(0.0F, 0.0F, 3.5F), 0.1F, false));
  EXPECT_TRUE(collides(map, Vector3f(2.0F, 1.0F, 4.0F), 2.5F, false));
  EXPECT_FALSE(collides(map, Vector3f(4.6F, 4.6F, 3.5F), 1.0F, false));
}

TEST(Collision, ASphereLargerThanAnyMapCollidesAtOnce) {
  const AtomMap map = makeBlock(3);
  EXPECT_TRUE(collides(map, Vector3f(0.0F, 0.0F, 1e6F), 1e5F, false));
  EXPECT_TRUE(collides(map, Vector3f::Zero(), 1e30F, false));
  EXPECT_TRUE(collides(map, Vector3f::Zero(), 1e30F, true));
}

TEST(Collision, InSignedDistanceModeWhatLiesBehindASurfaceCollides) {
  AtomMap map(Mode::kSignedDistance, kRadius);
  const float behind[2] = {-0.2F, 0.01F};
  const float before[2] = {0.2F, 0.01F};
  map.atoms().insert(Vector3f::Zero(), behind);
  map.atoms().insert(Vector3f(0.0F, 0.0F, 1.0F), before);
  EXPECT_TRUE(collides(map, Vector3f(0.0F, 0.0F, 0.4F), 0.0F, false));
  EXPECT_FALSE(collides(map, Vector3f(0.0F, 0.0F, 1.0F), 0.2F, false));
}

// By the definition: over all atoms, and over its poles and points drawn in it.
struct Truth {
  bool touches = false;   // an occupied atom, or occupied space where it comes nearest to one
  bool occupied = false;  // some point
  bool unknown = false;   // some point
};

template <class Draw>
Truth searchByForce(const AtomMap& map, const Vector3f& center, float radius, const Draw& draw) {
  Truth truth;
  map.atoms().forEach([&](ConstAtomRef atom) {
    const Vector3f towards = atom.center() - center;
    const bool overlaps = towards.norm() < radius + kRadius;
    const bool is_near = towards.norm() < radius + 2.0F * kRadius;
    if (atom.value() < 0.0F || !is_near) return;
    const auto there = interpolate(map, center + radius * towards.normalized());
    truth.touches = truth.touches || overlaps || (there && *there > 0.0F);
  });
  for (int j = 0; j < 3000; ++j) {
    Vector3f offset(draw(radius), draw(radius), draw(radius));
    if (j < 6) offset = (j % 2 == 0 ? radius : -radius) * Vector3f::Unit(j / 2);  // where it may just so reach out
    if (offset.norm() > radius) continue;
    const Occupancy there = classify(interpolate(map, center + offset));
    truth.occupied = truth.occupied || there == Occupancy::kOccupied;
    truth.unknown = truth.unknown || there == Occupancy::kUnknown;
  }
  return truth;
}

TEST(Collision, AgreesWithBruteForceOnRandomMaps) {
  Random random(1);
  const auto draw = [&](float half) { return half * (2.0F * random.uniform() - 1.0F); };
  AtomMap map(Mode::kOccupancy, kRadius);
  for (int i = 0; i < 3000; ++i) {
    const Vector3f center(draw(8.0F), draw(8.0F), draw(8.0F));
    if (map.atoms().nearest(center, 2.0F * kRadius)) continue;
    add(map, center, random.uniform() < 0.03F ? kOccupied : kFree);
  }
  int collisions = 0;
  int missed_occupied = 0;
  int missed_unknown = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3f center(draw(7.0F), draw(7.0F), draw(7.0F));
    const float radius = 2.0F * random.uniform();
    const Truth truth = searchByForce(map, center, radius, draw);
    const bool with_occupied = collides(map, center, radius, true);
    const bool with_unknown = collides(map, center, radius, false);
    ASSERT_EQ(with_occupied, truth.touches);
    ASSERT_TRUE(with_unknown || !with_occupied);
    ASSERT_TRUE(with_occupied || truth.unknown || !with_unknown) << "unknown space where there is none";
    missed_occupied += truth.occupied && !with_occupied ? 1 : 0;
    missed_unknown += truth.unknown && !with_unknown ? 1 : 0;
    collisions += with_unknown ? 1 : 0;
  }
  EXPECT_GT(collisions, 100);
  EXPECT_LT(collisions, 950);
  EXPECT_LT(missed_occupied, 20);
  EXPECT_LT(missed_unknown, 100);  // spheres that hold a hole narrower than an atom only
}

}  // namespace
}  // namespace atom_map
