// Stage 3: where candidates lie along the ray and the normal of a surface point (paper III-C, Fig. 2).
#include "atom_mapping/scan/rays.h"

#include <gtest/gtest.h>

#include <cmath>

#include "draw.h"
#include "trace_all.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

struct Case {
  Vector3f sensor;
  SurfacePoint point;
  float range;
  float facing;  // cosine between normal and ray
};

// A sensor, and a surface seen from it at up to 80 degrees of incidence.
Case drawCase(Random& random) {
  const Vector3f sensor = drawWithin(random, 50.0F);
  const Vector3f direction = drawDirection(random);
  const float range = draw(random, 0.5F, 24.0F);
  Vector3f normal = drawDirection(random);
  while (normal.dot(-direction) < 0.17F) normal = drawDirection(random);
  return {sensor, {sensor + range * direction, normal, kWide}, range, normal.dot(-direction)};
}

float planeDistance(const SurfacePoint& plane, const Vector3f& point) {
  return plane.normal.dot(point - plane.position);
}

class Rays : public testing::TestWithParam<int> {
 protected:
  Rays() {
    Random random(static_cast<std::uint64_t>(GetParam()));
    case_ = drawCase(random);
    candidates_ = trace({case_.point}, case_.sensor);
  }

  Case case_;
  Candidates candidates_;
};

TEST_P(Rays, StepAPlacesOneOccupiedAtomTangentBeneathTheSurface) {
  ASSERT_EQ(candidates_.occupied.size(), 1U);
  const Candidate& atom = candidates_.occupied[0];
  EXPECT_LT((atom.center - (case_.point.position - kRadius * case_.point.normal)).norm(), kRounding);
  EXPECT_NEAR(atom.value, std::log(0.7 / 0.3), 1e-6);
}

TEST_P(Rays, FirstFreeAtomOfStepBIsTangentToTheSurface) {
  if (case_.range < kRadius / case_.facing) return;
  ASSERT_FALSE(candidates_.free.empty());
  EXPECT_NEAR(planeDistance(case_.point, candidates_.free[0].center), kRadius, kRounding);
}

TEST_P(Rays, FreeAtomsLieOnTheRayADiameterApartBetweenSurfaceAndSensor) {
  const Vector3f towards_sensor = (case_.sensor - case_.point.position).normalized();
  float last = kRadius / case_.facing - 2.0F * kRadius;
  for (const Candidate& atom : candidates_.free) {
    const float along = towards_sensor.dot(atom.center - case_.point.position);
    EXPECT_LT((case_.point.position + along * towards_sensor - atom.center).norm(), kRounding) << "beside the ray";
    EXPECT_NEAR(along - last, 2.0F * kRadius, kRounding);
    EXPECT_GT(along, 0.0F);
    EXPECT_LT(along, case_.range + kRounding) << "behind the sensor";
    EXPECT_NEAR(atom.value, std::log(0.3 / 0.7), 1e-6);
    last = along;
  }
  EXPECT_GT(last + 2.0F * kRadius, case_.range - kRounding) << "one more would have fitted";
  EXPECT_EQ(candidates_.proposed, candidates_.size());
}

INSTANTIATE_TEST_SUITE_P(Seeds, Rays, testing::Range(1, 41));

}  // namespace
}  // namespace atom_map
