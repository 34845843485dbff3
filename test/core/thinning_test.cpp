// Stage 1: one return is traced of each cell.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

#include "atom_mapping/scan/filter.h"
#include "draw.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

FilteredScan thin(const std::vector<Vector3f>& points, double cell, std::uint64_t seed) {
  ScanParameters parameters;
  parameters.thinning = cell;  // of a radius of 1 m
  Random random(seed);
  return filterScan({points, {}}, 1.0, parameters, random);
}

std::tuple<int, int, int> cellOf(const Vector3f& point, float side) {
  const auto cell = [&](int axis) { return static_cast<int>(std::floor(point[axis] / side)); };
  return {cell(0), cell(1), cell(2)};
}

TEST(Thinning, KeepsExactlyOneReturnOfEveryCell) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    std::vector<Vector3f> points(3000);
    for (Vector3f& point : points) point = draw(random, 1.0F, 8.0F) * drawDirection(random);
    std::map<std::tuple<int, int, int>, int> cells;
    for (const Vector3f& point : points) cells[cellOf(point, 0.75F)] = 0;
    const FilteredScan scan = thin(points, 0.75, seed);
    for (const std::uint32_t ray : scan.rays) ++cells.at(cellOf(scan.points[ray], 0.75F));
    for (const auto& [cell, kept] : cells) ASSERT_EQ(kept, 1);
    ASSERT_EQ(scan.points.size(), points.size()) << "those that are not traced still tell of the surface";
  }
}

TEST(Thinning, KeepsEachReturnOfACellWithTheSameProbability) {
  const std::vector<Vector3f> points = {{5.1F, 5.1F, 5.1F}, {5.2F, 5.3F, 5.4F}, {5.9F, 5.9F, 5.9F}, {7.5F, 0.5F, 0.5F},
                                        {5.5F, 5.5F, 5.5F}, {5.1F, 5.9F, 5.1F}, {5.1F, 5.1F, 5.2F}};
  constexpr int kSeeds = 30000;
  std::vector<int> kept(points.size());
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    for (const std::uint32_t ray : thin(points, 1.0, seed).rays) ++kept[ray];
  }
  EXPECT_EQ(kept[3], kSeeds) << "alone in its cell";
  kept.erase(kept.begin() + 3);
  const double expected = kSeeds / 6.0;
  for (const int count : kept) EXPECT_NEAR(count, expected, 5.0 * std::sqrt(expected * 5.0 / 6.0));
}

}  // namespace
}  // namespace atom_map
