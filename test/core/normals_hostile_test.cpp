// Stage 2 over scans that no lidar would take: whatever comes, a surface point is whole.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "atom_mapping/scan/normals.h"
#include "draw.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

std::vector<SurfacePoint> estimated(const FilteredScan& scan, const ScanParameters& parameters, NormalReport& report) {
  std::vector<KnownPlane> known;
  return estimateSurface(scan, Eigen::Isometry3f::Identity(), 0.5, parameters, known, report);
}

// A surface point for each ray, in its order and place, with a unit normal that does not point away from the sensor and
// a width that is positive.
void expectWhole(const std::vector<Vector3f>& points, const ScanParameters& parameters) {
  Random random(1);
  const FilteredScan scan = filterScan({points, {}}, 0.5, parameters, random);
  NormalReport report;
  const std::vector<SurfacePoint> surface = estimated(scan, parameters, report);
  ASSERT_EQ(surface.size(), scan.rays.size());
  ASSERT_LE(report.from_line + report.from_ray, surface.size());
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const Vector3f& position = scan.points[scan.rays[i]];
    ASSERT_EQ(surface[i].position, position);
    ASSERT_NEAR(surface[i].normal.norm(), 1.0F, 1e-4F) << "at " << position.transpose();
    ASSERT_LE(surface[i].normal.dot(position.normalized()), 1e-4F) << "at " << position.transpose();
    ASSERT_GT(surface[i].half_width, 0.0F);
  }
}

// Whatever the parameters say of the sensor.
void expectWhole(const std::vector<Vector3f>& points) {
  for (const double noise : {0.0, 0.02, 1.0}) {
    for (const double support : {0.01, 0.15, 10.0}) {
      ScanParameters parameters;
      parameters.thinning = 0.0;
      parameters.range_noise = noise;
      parameters.normal_support = support;
      expectWhole(points, parameters);
    }
  }
}

std::vector<Vector3f> drawMany(std::uint64_t seed, int count, const std::function<Vector3f(Random&)>& draw_point) {
  Random random(seed);
  std::vector<Vector3f> points;
  for (int i = 0; i < count; ++i) points.push_back(draw_point(random));
  return points;
}

TEST(NormalsHostile, NoPointGivesNoneAndOnePointFacesTheSensor) {
  expectWhole(std::vector<Vector3f>{});
  for (const Vector3f& point : {Vector3f(3, 4, 0), Vector3f(0, 0, 7), Vector3f(0, 0, -7), Vector3f(-1, 0, 0)}) {
    Random random(1);
    const FilteredScan scan = filterScan({{point}, {}}, 0.5, ScanParameters{}, random);
    NormalReport report;
    const std::vector<SurfacePoint> surface = estimated(scan, ScanParameters{}, report);
    ASSERT_EQ(surface.size(), 1U);
    EXPECT_TRUE(surface[0].normal.isApprox(-point.normalized()));
    EXPECT_EQ(report.from_ray, 1U);
  }
}

TEST(NormalsHostile, NoiseInAllDirections) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    expectWhole(drawMany(seed, 5000, [](Random& r) -> Vector3f { return draw(r, 0.0F, 30.0F) * drawDirection(r); }));
  }
}

TEST(NormalsHostile, NoiseInANarrowBeam) {
  expectWhole(drawMany(4, 3000, [](Random& r) -> Vector3f { return Vector3f(5, 0, 0) + drawWithin(r, 0.3F); }));
  expectWhole(drawMany(5, 3000, [](Random& r) -> Vector3f { return Vector3f(0, 0, 5) + drawWithin(r, 0.3F); }));
}

TEST(NormalsHostile, TheSamePointOverAndOver) {
  expectWhole(std::vector<Vector3f>(500, Vector3f(2, 1, 0.5F)));
  expectWhole(std::vector<Vector3f>(500, Vector3f(0, 0, -2)));
}

TEST(NormalsHostile, PointsOnALine) {
  const auto onLine = [](const Vector3f& start, const Vector3f& step) {
    std::vector<Vector3f> points;
    for (int i = 0; i < 500; ++i) points.push_back(start + static_cast<float>(i) * step);
    return points;
  };
  expectWhole(onLine({1, 0, 0}, {0.02F, 0, 0}));      // along a ray
  expectWhole(onLine({3, -2, 0.1F}, {0, 0.01F, 0}));  // across the rays, on one ring
  expectWhole(onLine({3, 0, -2}, {0, 0, 0.01F}));     // across the rings
  expectWhole(onLine({0, 0, 1}, {0, 0, 0.02F}));      // on the sensor's axis
}

TEST(NormalsHostile, TwoRingsOnly) {
  expectWhole(drawMany(6, 3000, [](Random& r) -> Vector3f {
    const float azimuth = draw(r, -3.2F, 3.2F);
    return Vector3f(8.0F * std::cos(azimuth), 8.0F * std::sin(azimuth), drawIndex(r, 2) == 0 ? 0.0F : 0.3F);
  }));
}

TEST(NormalsHostile, CoarseAndFineSensors) {
  const auto points = drawMany(7, 2000, [](Random& r) -> Vector3f { return draw(r, 0.6F, 30.0F) * drawDirection(r); });
  for (const double degrees : {0.05, 1.0, 3.0, 10.0, 45.0}) {
    for (const double support : {0.15, 10.0}) {
      ScanParameters parameters;
      parameters.thinning = 0.0;
      parameters.horizontal_resolution = degrees;
      parameters.vertical_resolution = degrees;
      parameters.normal_support = support;
      expectWhole(points, parameters);
    }
  }
}

TEST(NormalsHostile, ReturnsMuchNearerAndMuchFartherThanAnyLidars) {
  ScanParameters parameters;
  parameters.thinning = 0.0;
  parameters.min_range = 0.0;
  parameters.max_range = 1000.0;
  expectWhole(drawMany(8, 3000,
                       [](Random& r) -> Vector3f { return std::pow(10.0F, draw(r, -30.0F, 6.0F)) * drawDirection(r); }),
              parameters);
}

}  // namespace
}  // namespace atom_map
