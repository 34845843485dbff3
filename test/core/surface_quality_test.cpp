// Q and F on maps with a known answer, and the ground of Fig. 9.
#include "atom_mapping/evaluation/surface_quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "atom_mapping/evaluation/compared_map.h"
#include "atom_mapping/evaluation/recorded_drive.h"
#include "simulated.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

class SurfaceQualityOf : public testing::TestWithParam<const char*> {
 protected:
  SurfaceQuality measure(const AskOccupancy& ask) const { return measureSurfaceQuality(scene_, epsilon_, ask, 1); }

  // Free where the true distance is more than `shift`.
  SurfaceQuality measureShifted(double shift) const {
    return measure([&](const Vector3d& point) {
      return scene_.signedDistance(point) > shift ? Occupancy::kFree : Occupancy::kOccupied;
    });
  }

  const Scene scene_ = makeScene(GetParam());
  const std::vector<double> epsilon_{0.02, 0.1, 0.4};
};

TEST_P(SurfaceQualityOf, ATrueMapHasQOneAndFZero) {
  const SurfaceQuality quality = measureShifted(0.0);
  ASSERT_EQ(quality.q.size(), epsilon_.size());
  for (std::size_t i = 0; i < epsilon_.size(); ++i) {
    EXPECT_EQ(quality.q[i].value(), 1.0);
    EXPECT_EQ(quality.f[i].value(), 0.0);
    EXPECT_EQ(standardError(quality.q[i]), 0.0);
    EXPECT_EQ(quality.q[i].whole, 40000U);
    EXPECT_EQ(quality.f[i].whole, 40000U);
  }
}

TEST_P(SurfaceQualityOf, MapsOfOneAnswer) {
  const SurfaceQuality free = measure([](const Vector3d&) { return Occupancy::kFree; });
  const SurfaceQuality unknown = measure([](const Vector3d&) { return Occupancy::kUnknown; });
  const SurfaceQuality occupied = measure([](const Vector3d&) { return Occupancy::kOccupied; });
  for (std::size_t i = 0; i < epsilon_.size(); ++i) {
    EXPECT_EQ(free.q[i].value() * free.f[i].value(), 1.0);
    EXPECT_EQ(unknown.q[i].value() + unknown.f[i].value() + occupied.q[i].value() + occupied.f[i].value(), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(ClosedScenes, SurfaceQualityOf, testing::Values("cube", "cube_rotated", "sphere"));

// Of the shell of depth epsilon in a cube or a sphere of half size 1, what lies deeper than 3 cm.
TEST(SurfaceQuality, AShiftedSurfaceCostsTheVolumeThatItTakes) {
  for (const char* name : {"cube", "sphere"}) {
    const Scene scene = makeScene(name);
    const std::vector<double> epsilon{0.02, 0.04, 0.1, 0.4};
    const auto ask = [&](const Vector3d& point) {
      return scene.signedDistance(point) > 0.03 ? Occupancy::kFree : Occupancy::kUnknown;
    };
    const SurfaceQuality quality = measureSurfaceQuality(scene, epsilon, ask, 1);
    for (std::size_t i = 0; i < epsilon.size(); ++i) {
      const auto within = [](double depth) { return 1.0 - std::pow(1.0 - depth, 3); };
      const double expected = epsilon[i] <= 0.03 ? 0.0 : 1.0 - within(0.03) / within(epsilon[i]);
      EXPECT_NEAR(quality.q[i].value(), expected, 4.0 * standardError(quality.q[i]) + 1e-9) << name << epsilon[i];
    }
  }
}

// Returns of the cube's bottom: next to them lies a slab, of which a shift costs its share.
TEST(SurfaceQuality, AtReturnsAShiftedSurfaceCostsTheShareThatItTakes) {
  const Scene scene = makeScene("cube");
  const std::vector<ObservedRay> rays{{Vector3d::Zero(), Vector3d(0.1, 0.2, -1.0), Vector3d::UnitZ(), false},
                                      {Vector3d::Zero(), Vector3d(-0.3, 0.1, -1.01), Vector3d::UnitZ(), false}};
  const std::vector<double> epsilon{0.02, 0.1, 0.4};
  const auto measure = [&](double shift) {
    const auto ask = [=, &scene](const Vector3d& point) {
      return scene.signedDistance(point) > shift ? Occupancy::kFree : Occupancy::kUnknown;
    };
    return measureQualityAtReturns(scene, rays, epsilon, ask, 1);
  };
  const SurfaceQuality outwards = measure(-0.03);
  const SurfaceQuality inwards = measure(0.03);
  for (std::size_t i = 0; i < epsilon.size(); ++i) {
    const double share = std::min(0.03 / epsilon[i], 1.0);
    EXPECT_EQ(outwards.q[i].value(), 1.0);
    EXPECT_EQ(inwards.f[i].value(), 0.0);
    EXPECT_NEAR(outwards.f[i].value(), share, 0.015);
    EXPECT_NEAR(inwards.q[i].value(), 1.0 - share, 0.015);
  }
}

TEST(SurfaceQuality, WithoutAReturnThereIsNothingToJudge) {
  EXPECT_TRUE(measureQualityAtReturns(makeScene("cube"), {}, {0.1}, {}, 1).q.empty());
}

TEST(SurfaceQuality, DistancesGoFromATenthToFourRadii) {
  const std::vector<double> distances = distancesFromSurface(0.5);
  EXPECT_DOUBLE_EQ(distances.front(), 0.05);
  EXPECT_DOUBLE_EQ(distances.back(), 2.0);
  EXPECT_TRUE(std::is_sorted(distances.begin(), distances.end()));
  EXPECT_TRUE(std::count(distances.begin(), distances.end(), 0.5) == 1) << "the radius itself";
}

TEST(SurfaceQuality, StandardErrorIsThatOfIndependentDraws) {
  EXPECT_DOUBLE_EQ(standardError({50, 100}), 0.05);
  EXPECT_EQ(standardError({0, 0}), 0.0);
}

TEST(GroundKept, CountsReturnsThatAreOccupiedAtOrBeneathThem) {
  const std::vector<ObservedRay> rays{{Vector3d(0, 0, 2), Vector3d(0, 0, 0), Vector3d::UnitZ(), false},
                                      {Vector3d(0, 0, 2), Vector3d(1, 0, 0), Vector3d::UnitZ(), false}};
  const auto kept = [&](double low, double high) {
    return measureGroundKept(rays, 0.4, [&](const Vector3d& p) {
      return p.x() < 0.5 && p.z() >= low && p.z() <= high ? Occupancy::kOccupied : Occupancy::kFree;
    });
  };
  EXPECT_EQ(kept(-0.01, 0.01).value(), 0.5);
  EXPECT_EQ(kept(-0.5, -0.3).value(), 0.5);
  EXPECT_EQ(kept(0.1, 0.5).value(), 0.0);
  EXPECT_EQ(kept(-0.9, -0.5).value(), 0.0);
}

TEST(Slope, EveryReturnIsOfTheGroundThatTheRobotClimbs) {
  for (const double slope : {0.0, 10.0}) {
    LidarModel model;
    model.noise_sigma = 0.0;
    const Scene scene = makeSlope(slope);
    const RecordedDrive drive = recordDrive(scene, makeClimb(slope), model, 2, 1, ScanParameters());
    ASSERT_GT(drive.rays.size(), 10000U);
    for (const ObservedRay& ray : drive.rays) {
      ASSERT_NEAR(scene.signedDistance(ray.end), 0.0, 1e-4);
      ASSERT_NEAR(ray.normal->z(), std::cos(slope * M_PI / 180.0), 1e-6);
      ASSERT_NEAR(scene.signedDistance(ray.sensor), 1.6, 1e-6);
    }
    EXPECT_NEAR(drive.poses[1].translation().z() - drive.poses[0].translation().z(),
                0.1 * std::sin(slope * M_PI / 180.0), 1e-9);
  }
}

}  // namespace
}  // namespace atom_map
