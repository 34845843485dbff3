// Stage 1: which returns of a scan are used, as REP 117 and the ranges say.
#include "atom_mapping/scan/filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "draw.h"
#include "reproducible.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

ScanParameters makeParameters(double thinning) {
  ScanParameters parameters;
  parameters.min_range = 0.5;
  parameters.max_range = 25.0;
  parameters.thinning = thinning;
  return parameters;
}

FilteredScan filter(const std::vector<Vector3f>& points, double thinning = 0.0, std::uint64_t seed = 1) {
  Random random(seed);
  return filterScan({points, {}}, 1.0, makeParameters(thinning), random);
}

std::uint32_t dropped(const FilterReport& report) {
  return report.nan + report.no_return + report.too_near + report.too_far + report.thinned;
}

TEST(Filter, NanIsIgnoredAndCounted) {
  const FilteredScan scan = filter({{kNan, 1, 1}, {1, kNan, 1}, {1, 1, kNan}, {kNan, kInf, 1}, {-kInf, kNan, kInf}});
  EXPECT_EQ(scan.report.nan, 5U);
  EXPECT_EQ(dropped(scan.report), 5U);
  EXPECT_TRUE(scan.points.empty() && scan.rays.empty());
}

TEST(Filter, PositiveInfinityIsNoReturn) {
  const FilteredScan scan = filter({{kInf, kInf, kInf}, {kInf, 1, 1}, {1, 1, kInf}, {-kInf, kInf, 2}});
  EXPECT_EQ(scan.report.no_return, 4U);
  EXPECT_EQ(dropped(scan.report), 4U);
  EXPECT_TRUE(scan.points.empty() && scan.rays.empty());
}

TEST(Filter, NegativeInfinityIsTooNear) {
  const FilteredScan scan = filter({{-kInf, -kInf, -kInf}, {1, -kInf, 3}});
  EXPECT_EQ(scan.report.too_near, 2U);
  EXPECT_EQ(dropped(scan.report), 2U);
  EXPECT_TRUE(scan.points.empty() && scan.rays.empty());
}

TEST(Filter, RangesAreOfTheWholeVectorAndTheirLimitsBelongToThem) {
  const FilteredScan scan =
      filter({{0.49F, 0, 0}, {0.3F, 0.4F, 0}, {0, 0, 0}, {15, 20, 0}, {0, 0, -25.1F}, {0, 20, 16}});
  EXPECT_EQ(scan.report.too_near, 2U);
  EXPECT_EQ(scan.report.too_far, 2U);
  ASSERT_EQ(scan.rays.size(), 2U);
  EXPECT_EQ(scan.points[scan.rays[0]], Vector3f(0.3F, 0.4F, 0));
  EXPECT_EQ(scan.points[scan.rays[1]], Vector3f(15, 20, 0));
}

TEST(Filter, AFinitePointIsTooFarHoweverFar) {
  const FilteredScan scan = filter({{1e30F, 0, 0}, {0, -3e38F, 0}});
  EXPECT_EQ(scan.report.too_far, 2U);
  EXPECT_EQ(dropped(scan.report), 2U);
  EXPECT_TRUE(scan.rays.empty());
}

TEST(Filter, AReturnAtTheSensorItselfIsTooNearEvenWithoutAMinimumRange) {
  ScanParameters parameters = makeParameters(0.0);
  parameters.min_range = 0.0;
  Random random(1);
  const FilteredScan scan = filterScan({{{0, 0, 0}, {1e-3F, 0, 0}, {1e-30F, 0, 0}}, {}}, 1.0, parameters, random);
  EXPECT_EQ(scan.report.too_near, 2U);
  EXPECT_EQ(scan.rays.size(), 1U);
}

TEST(Filter, PointsBeyondTheMaximumRangeStayForTheNormalsOfNearerOnes) {
  const FilteredScan scan = filter({{24, 0, 0}, {26, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(scan.points.size(), 3U);
  EXPECT_EQ(scan.rays, (std::vector<std::uint32_t>{0, 2}));
}

TEST(Filter, AnEmptyScanStaysEmpty) {
  const FilteredScan scan = filter({}, 0.5);
  EXPECT_TRUE(scan.points.empty() && scan.rays.empty());
  EXPECT_EQ(scan.report.points_in, 0U);
}

// A coordinate of any kind, hostile ones among them.
rc::Gen<float> genCoordinate() {
  const auto in_range =
      rc::gen::map(rc::gen::inRange(-30000, 30000), [](int x) { return 1e-3F * static_cast<float>(x); });
  return rc::gen::weightedOneOf<float>({{20, in_range},
                                        {1, rc::gen::element(kNan, kInf, -kInf, 0.0F, -0.0F, 1e-30F)},
                                        {1, rc::gen::element(1e15F, std::numeric_limits<float>::min(), -1e15F)}});
}

RC_GTEST_PROP(Filter, CountsAddUpToThePointsThatCameIn, ()) {
  using Coordinates = std::array<float, 3>;
  const auto coordinates =
      *rc::gen::container<std::vector<Coordinates>>(rc::gen::container<Coordinates>(genCoordinate()));
  std::vector<Vector3f> points;
  for (const auto& c : coordinates) points.emplace_back(c[0], c[1], c[2]);
  const FilteredScan scan = filter(points, *rc::gen::element(0.0, 0.3, 2.0, 10.0));
  RC_ASSERT(scan.report.points_in == points.size());
  RC_ASSERT(dropped(scan.report) + scan.rays.size() == points.size());
  RC_ASSERT(std::is_sorted(scan.rays.begin(), scan.rays.end()));
  RC_ASSERT(std::adjacent_find(scan.rays.begin(), scan.rays.end()) == scan.rays.end());
  for (const Vector3f& point : scan.points) RC_ASSERT(point.allFinite());
  for (const std::uint32_t ray : scan.rays) {
    RC_ASSERT(scan.points.at(ray).norm() >= 0.5F);
    RC_ASSERT(scan.points.at(ray).norm() <= 25.0F);
  }
}

}  // namespace
}  // namespace atom_map
