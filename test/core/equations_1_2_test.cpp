// Equations (1) and (2) of the paper, which interleaving rests on, against values computed by hand and their limits.
#include <gtest/gtest.h>

#include <cmath>

#include "atom_mapping/scan/interleave.h"

namespace atom_map {
namespace {

constexpr float kDegree = 0.017453293F;
constexpr float kPi = 3.1415927F;

TEST(Equation1, AngleOfTouchingAtomsByHand) {
  EXPECT_NEAR(touchingAngle(0.5F, 1.0F), 60.0F * kDegree,
              1e-6F);  // an equilateral triangle
  EXPECT_NEAR(touchingAngle(1.0F, std::sqrt(2.0F)), 90.0F * kDegree,
              1e-6F);  // a square's corner
  EXPECT_NEAR(touchingAngle(0.5F, 10.0F), 2.0F * std::asin(0.05F),
              1e-5F);  // half the chord is r
  for (const double ratio : {0.4, 0.04, 4e-3, 1e-4, 1e-5}) {
    const double angle = 2.0 * std::asin(ratio);
    EXPECT_NEAR(touchingAngle(static_cast<float>(ratio), 1.0F), angle, 1e-6 * angle) << ratio;
  }
}

TEST(Equation1, AtomsAroundTheSensorTouchAllOthers) {
  for (const float distance : {0.0F, 0.1F, 0.4999F, 0.5F}) EXPECT_NEAR(touchingAngle(0.5F, distance), kPi, 1e-3F);
}

TEST(Equation1, OverlapCountByHand) {
  EXPECT_EQ(overlapCount(60.0F * kDegree, 1.0F / (7.0F * kDegree)),
            19.0F);  // 60 / 7 = 8.57: 9 on each side
  EXPECT_EQ(overlapCount(90.0F * kDegree, 1.0F / (40.0F * kDegree)),
            7.0F);  // 2.25: 3 on each side
  EXPECT_EQ(overlapCount(0.1000417F, 1.0F / (0.2F * kDegree)),
            59.0F);  // 28.66: 29 on each side
  EXPECT_EQ(overlapCount(1.0F * kDegree, 1.0F / (30.0F * kDegree)),
            3.0F);  // always one beside it on each side
}

TEST(Equation2, KeepProbabilityByHand) {
  EXPECT_FLOAT_EQ(keepProbability(3.0F, 0.0F), 1.0F / 3.0F);
  EXPECT_FLOAT_EQ(keepProbability(59.0F, 1.0F), 2.0F / 60.0F);
  EXPECT_FLOAT_EQ(keepProbability(5.0F, 3.0F), 0.5F);
}

TEST(Equation2, LimitsAreNoInterleavingAndOneInTheSet) {
  for (const float lambda : {0.0F, 1.0F, 100.0F}) EXPECT_FLOAT_EQ(keepProbability(1.0F, lambda), 1.0F);
  for (const float k : {3.0F, 59.0F, 999.0F}) {
    EXPECT_GT(keepProbability(k, 1e9F), 0.999F);
    EXPECT_FLOAT_EQ(k * keepProbability(k, 0.0F), 1.0F);
  }
}

TEST(Equation2, KeepProbabilityMaximisesTheObjective) {
  for (const double k : {2.0, 3.0, 7.0, 59.0, 399.0}) {
    for (const double lambda : {0.0, 0.3, 1.0, 4.0, 50.0}) {
      const auto objective = [&](double gamma) {
        return k * gamma * std::pow(1.0 - gamma, k - 1.0) - lambda * std::pow(1.0 - gamma, k);
      };
      const auto best = static_cast<double>(keepProbability(static_cast<float>(k), static_cast<float>(lambda)));
      double argmax = 0.0;
      for (int i = 1; i <= 100000; ++i) {
        if (objective(1e-5 * i) > objective(argmax)) argmax = 1e-5 * i;
      }
      EXPECT_NEAR(best, argmax, 2e-5) << "k " << k << " lambda " << lambda;
    }
  }
}

}  // namespace
}  // namespace atom_map
