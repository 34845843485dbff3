// Stage 3 at its limits: grazing rays, thin things, returns next to the sensor, rays without return.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "draw.h"
#include "trace_all.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

TEST(RaysOfOneSurface, AtomsOfStepsAAndBTouchWhereTheRayIsPerpendicular) {
  const Candidates candidates = trace({{{5, 0, 0}, {-1, 0, 0}, kWide}}, Vector3f::Zero());
  EXPECT_NEAR((candidates.occupied[0].center - candidates.free[0].center).norm(), 2.0F * kRadius, kRounding);
}

TEST(RaysOfOneSurface, GrazingRaysStayWithinTheGreatestIncidence) {
  const Candidates candidates = trace({{{9, 0, 0}, Vector3f(-1e-3F, 1, 0).normalized(), kWide}}, Vector3f::Zero());
  const float bound = kRadius / std::cos(84.0F * 0.017453293F);
  EXPECT_NEAR(9.0F - candidates.free.at(0).center.x(), bound, kRounding);
}

TEST(RaysOfOneSurface, AThinThingKeepsItsAtomNoDeeperThanItsMiddle) {
  for (const float half_width : {0.01F, 0.05F, 0.2F, 0.6F}) {
    const Candidates candidates = trace({{{5, 0, 0}, {-1, 0, 0}, half_width}}, Vector3f::Zero());
    const float depth = candidates.occupied.at(0).center.x() - 5.0F;
    EXPECT_GT(depth, 0.0F);
    EXPECT_LE(depth, std::min(half_width, kRadius) + kRounding);
    const float gap = candidates.occupied[0].center.x() - candidates.free.at(0).center.x();
    EXPECT_NEAR(gap, 2.0F * kRadius, kRounding) << "free and occupied atoms touch all the same";
  }
}

TEST(RaysOfOneSurface, AReturnNextToTheSensorFreesNothing) {
  EXPECT_TRUE(trace({{{0.2F, 0, 0}, {-1, 0, 0}, kWide}}, Vector3f::Zero()).free.empty());
}

TEST(RaysWithoutReturn, AreFreedFromTheMaximumRangeToTheSensor) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const Vector3f sensor = drawWithin(random, 30.0F);
    const Vector3f direction = drawDirection(random);
    const Candidates candidates = trace({}, sensor, {direction});
    EXPECT_TRUE(candidates.occupied.empty());
    ASSERT_EQ(candidates.free.size(), 42U);  // 25 m over 0.6 m, and the rest of a diameter
    for (std::size_t k = 0; k < candidates.free.size(); ++k) {
      const float range = 25.0F - kRadius * (1.0F + 2.0F * static_cast<float>(k));
      EXPECT_LT((sensor + range * direction - candidates.free[k].center).norm(), kRounding);
      EXPECT_NEAR(candidates.free[k].value, std::log(0.3 / 0.7), 1e-6);
    }
  }
}

}  // namespace
}  // namespace atom_map
