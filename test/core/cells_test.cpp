// Which cell a point lies in: one after another, and many at once.
#include "atom_mapping/base/cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <vector>

#include "draw.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

// Some of them on the borders of cells of a quarter metre.
std::vector<Vector3f> drawPoints(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  std::vector<Vector3f> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = drawWithin(random, 100.0F);
    if (i % 5 == 0) points[i] = 0.25F * (4.0F * points[i]).array().round();
  }
  return points;
}

bool isSame(const Cell& a, const Cell& b) {
  return std::tie(a.x, a.y, a.z) == std::tie(b.x, b.y, b.z);
}

TEST(Cells, APointLiesBetweenTheBordersOfItsCell) {
  for (const Vector3f& point : drawPoints(1, 5000)) {
    const Cell cell = cellOf(point, 4.0F);
    const Vector3f corner =
        0.25F * Vector3f(static_cast<float>(cell.x), static_cast<float>(cell.y), static_cast<float>(cell.z));
    ASSERT_TRUE((corner.array() <= point.array()).all() && (point.array() < corner.array() + 0.25F).all())
        << point.transpose();
  }
}

TEST(Cells, ManyAtOnceLieInTheSameAndComeInTheirOrder) {
  for (const std::size_t count : {0, 1, 255, 256, 257, 1000}) {
    const std::vector<Vector3f> points = drawPoints(count, count);
    std::size_t next = 0;
    forEachCell(
        count, 3.7F, [&](std::size_t i) { return points[i]; },
        [&](std::size_t i, const Cell& cell) {
          ASSERT_EQ(i, next++);
          EXPECT_TRUE(isSame(cell, cellOf(points[i], 3.7F))) << points[i].transpose();
        });
    EXPECT_EQ(next, count);
  }
}

}  // namespace
}  // namespace atom_map
