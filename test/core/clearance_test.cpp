#include "atom_mapping/planning/clearance.h"

#include <gtest/gtest.h>

#include "packed_map.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr float kRadius = 0.25F;

bool isOccupied(const AtomMap& map, ConstAtomRef atom) {
  return (map.mode() == Mode::kOccupancy ? atom.value() : -atom.value()) >= 0.0F;
}

// Least distance of a point to an atom's center, over all atoms or the occupied ones.
float nearestByForce(const AtomMap& map, const Vector3f& point, bool only_occupied) {
  float nearest = 1e9F;
  map.atoms().forEach([&](ConstAtomRef atom) {
    if (!only_occupied || isOccupied(map, atom)) nearest = std::min(nearest, (atom.center() - point).norm());
  });
  return nearest;
}

TEST(Clearance, SurfaceDistanceIsThatOfTheNearestOccupiedAtom) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const AtomMap map = makePackedMap(seed, Mode::kOccupancy, kRadius, 2.0F, 0.02F);
    Clearance clearance(map, {});
    for (int i = 0; i < 50; ++i) {
      const Vector3f point = drawWithin(random, 3.0F);
      const float reach = draw(random, 0.0F, 3.0F);
      const float expected = std::min(nearestByForce(map, point, true) - kRadius, reach);
      EXPECT_NEAR(clearance.surfaceDistance(point, reach), expected, 1e-5);
    }
  }
}

TEST(Clearance, InSignedDistanceModeItIsTheAtomsOwnOrTheEstimate) {
  const AtomMap map = makePackedMap(3, Mode::kSignedDistance, kRadius, 2.0F, 0.02F);
  Clearance clearance(map, {});
  GaussianProcess regression(map, GaussianProcessParameters());
  map.atoms().forEach([&](ConstAtomRef atom) {
    const float occupied = nearestByForce(map, atom.center(), true) - kRadius;
    EXPECT_NEAR(clearance.surfaceDistance(atom, 3.0F), std::min({occupied, atom.value(), 3.0F}), 1e-5);
    const float estimate = regression.estimate(atom.center())->value;
    EXPECT_NEAR(clearance.surfaceDistance(atom.center(), 3.0F), std::min({occupied, estimate, 3.0F}), 1e-5);
  });
}

// A way is known, or clear, if all of its points are; both are found exactly, so that sampling may miss a little only.
TEST(Clearance, WaysAreTestedAllAlong) {
  int known = 0;
  int clear = 0;
  int missed = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    AtomMap map = makePackedMap(seed, Mode::kOccupancy, kRadius, 1.5F, 0.08F);
    map.clearRegion({Eigen::Vector3d(-1.0, -0.4, -1.0), Eigen::Vector3d(1.0, 0.4, 1.0)});
    SafetyRules rules;
    rules.robot_radius = draw(random, 0.0F, 0.5F);
    const Clearance clearance(map, rules);
    for (int i = 0; i < 40; ++i) {
      const Vector3f from = drawWithin(random, 1.7F);
      const Vector3f to = from + draw(random, 0.0F, 1.0F) * drawDirection(random);
      bool is_known = true;
      bool is_clear = true;
      for (int k = 0; k <= 100; ++k) {
        const Vector3f point = from + 0.01F * static_cast<float>(k) * (to - from);
        is_known = is_known && nearestByForce(map, point, false) < 2.0F * kRadius;
        is_clear = is_clear && nearestByForce(map, point, true) >= rules.robot_radius + kRadius;
      }
      EXPECT_TRUE(is_known || !clearance.isKnown(from, to));
      EXPECT_TRUE(is_clear || !clearance.isClear(from, to));
      known += is_known ? 1 : 0;
      clear += is_clear ? 1 : 0;
      missed += is_known != clearance.isKnown(from, to) || is_clear != clearance.isClear(from, to) ? 1 : 0;
    }
  }
  EXPECT_GT(known, 100);
  EXPECT_LT(known, 700);
  EXPECT_GT(clear, 100);
  EXPECT_LT(clear, 700);
  EXPECT_LT(missed, 16);
}

}  // namespace
}  // namespace atom_map
