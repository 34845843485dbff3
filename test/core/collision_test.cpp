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

TEST(Collision, OverlapWithAnOccupiedAtomBeginsAtTheSumOfTheRadii) {
  AtomMap map(Mode::kOccupancy, kRadius);
  add(map, Vector3f::Zero(), kOccupied);
  EXPECT_TRUE(collides(map, Vector3f(1.49F, 0.0F, 0.0F), 1.0F, true));
  EXPECT_FALSE(collides(map, Vector3f(1.51F, 0.0F, 0.0F), 1.0F, true));
  EXPECT_TRUE(collides(map, Vector3f(0.0F, 0.49F, 0.0F), 0.0F, true));
  EXPECT_FALSE(collides(map, Vector3f(0.0F, 0.51F, 0.0F), 0.0F, true));
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

// By the definition, over all atoms.
bool overlapsOccupiedByForce(const AtomMap& map, const Vector3f& center, float radius) {
  bool found = false;
  map.atoms().forEach([&](ConstAtomRef atom) {
    found = found || (atom.value() > 0.0F && (atom.center() - center).norm() < radius + kRadius);
  });
  return found;
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
  int missed = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3f center(draw(7.0F), draw(7.0F), draw(7.0F));
    const float radius = 2.0F * random.uniform();
    const bool occupied = overlapsOccupiedByForce(map, center, radius);
    ASSERT_EQ(collides(map, center, radius, true), occupied);
    bool unknown = false;
    for (int j = 0; j < 3000; ++j) {
      const Vector3f offset(draw(radius), draw(radius), draw(radius));
      if (offset.norm() > radius) continue;
      unknown = unknown || !interpolate(map, center + offset);
    }
    const bool answer = collides(map, center, radius, false);
    ASSERT_TRUE(answer || !occupied);
    ASSERT_TRUE(occupied || unknown || !answer) << "at " << center.transpose() << ", radius " << radius;
    missed += unknown && !answer ? 1 : 0;
    collisions += answer ? 1 : 0;
  }
  EXPECT_GT(collisions, 200);
  EXPECT_LT(collisions, 1900);
  EXPECT_LT(missed, 200);  // spheres that hold a hole narrower than an atom only
}

}  // namespace
}  // namespace atom_map
