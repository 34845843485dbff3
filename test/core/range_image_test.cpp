// The range image finds the returns beside one another, of organized and of unorganized scans.
#include "atom_mapping/scan/range_image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "atom_mapping/sim/make_scene.h"
#include "atom_mapping/sim/simulate_scan.h"
#include "draw.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr double kDegree = M_PI / 180.0;

RangeImage makeImage(const std::vector<Vector3f>& points) {
  return {points, 0.2 * kDegree, 2.0 * kDegree};
}

Vector3f fromAngles(double azimuth, double elevation, double range = 10.0) {
  const Eigen::Vector3d direction(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                                  std::sin(elevation));
  return (range * direction).cast<float>();
}

TEST(RangeImage, PixelHoldsTheNearestOfItsReturns) {
  Random random(1);
  std::vector<Vector3f> points(20000);
  for (Vector3f& point : points) point = draw(random, 0.1F, 50.0F) * drawDirection(random);
  const RangeImage image = makeImage(points);
  std::map<std::pair<int, int>, float> nearest;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto [row, column] = image.pixel(i);
    const auto [place, first] = nearest.emplace(std::make_pair(row, column), points[i].squaredNorm());
    if (!first) place->second = std::min(place->second, points[i].squaredNorm());
  }
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto [row, column] = image.pixel(i);
    const std::int32_t found = image.at(row, column).index;
    ASSERT_GE(found, 0);
    EXPECT_EQ(points[static_cast<std::size_t>(found)].squaredNorm(), nearest.at({row, column}));
  }
}

TEST(RangeImage, ColumnsCloseACircle) {
  const RangeImage image = makeImage({fromAngles(M_PI - 0.05 * kDegree, 0.0), fromAngles(-M_PI + 0.05 * kDegree, 0.0)});
  const auto [row, last] = image.pixel(0);
  const int first = image.pixel(1).column;
  EXPECT_EQ(image.at(row, last + 1).index, 1) << "the next column after the last is the first";
  EXPECT_EQ(image.at(row, first - 1).index, 0);
  EXPECT_EQ(image.at(row, last - 1800).index, 0) << "a turn before the image";
  EXPECT_EQ(image.at(row, first + 1800).index, 1) << "a turn behind it";
  EXPECT_NEAR(image.columnAngle(), 0.2 * kDegree, 1e-6);
}

TEST(RangeImage, AnyRowMayBeAskedForAndHoldsEveryReturnOnce) {
  for (const auto& points :
       {std::vector<Vector3f>{}, {Vector3f(0, 0, 5)}, {Vector3f(0, 0, -5)}, {Vector3f(-5, 0, 0)}}) {
    const RangeImage image = makeImage(points);
    int found = 0;
    for (int row = -200; row < 300; ++row) {
      for (int column = 0; column < 1800; ++column) found += image.at(row, column).index >= 0 ? 1 : 0;
    }
    EXPECT_EQ(found, static_cast<int>(points.size()));
    for (const int row : {-1000000, 1000000}) EXPECT_EQ(image.at(row, 0).index, -1);
  }
}

TEST(RangeImage, NeighboursInAzimuthAreNeighboursInColumns) {
  std::vector<Vector3f> points;
  for (int i = 0; i < 1800; ++i) points.push_back(fromAngles((0.2 * i + 0.1) * kDegree, 0.03));
  const RangeImage image = makeImage(points);
  for (std::uint32_t i = 0; i < 1800; ++i) {
    const auto [row, column] = image.pixel(i);
    EXPECT_EQ(image.at(row, column).index, static_cast<std::int32_t>(i));
    EXPECT_EQ(image.at(row, column + 1).index, static_cast<std::int32_t>((i + 1) % 1800));
  }
}

// A sensor's rings do not lie exactly 2 degrees apart, and not at multiples of 2 degrees.
TEST(RangeImage, EachRingOfASensorIsOneRowAndTheNextRingTheNextRow) {
  for (double offset = -1.0; offset < 1.0; offset += 0.06) {
    Random random(2);
    std::vector<Vector3f> points;
    for (int ring = 0; ring < 16; ++ring) {
      for (int i = 0; i < 200; ++i) {
        const double error = 0.12 * static_cast<double>(draw(random, -1.0F, 1.0F));
        points.push_back(fromAngles(0.03 * i, (-15.0 + 2.0 * ring + offset + error) * kDegree));
      }
    }
    const RangeImage image = makeImage(points);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(image.pixel(i).row - image.pixel(0).row, static_cast<int>(i) / 200) << "offset " << offset;
    }
  }
}

TEST(RangeImage, SimulatedScanHasItsRingsInRowsAndItsFiringsInColumns) {
  const SimulatedScan scan = simulateScan(makeScene("hall"), makeTrajectory("hall"), 0.0, LidarModel{}, 1);
  const RangeImage image = makeImage(toLidarScan(scan).points);
  int shared = 0;
  for (std::uint32_t i = 0; i < scan.returns.size(); ++i) {
    ASSERT_EQ(image.pixel(i).row - image.pixel(0).row, scan.returns[i].ring - scan.returns[0].ring);
    shared += image.at(image.pixel(i).row, image.pixel(i).column).index != static_cast<std::int32_t>(i) ? 1 : 0;
  }
  RecordProperty("returns_behind_another_of_their_pixel", shared);
  EXPECT_LT(shared, static_cast<int>(scan.returns.size() / 10));
}

}  // namespace
}  // namespace atom_map
