#include "atom_mapping/scan/neighborhood.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "atom_mapping/base/angles.h"

namespace atom_map {
namespace {

// A ring 20 m away, level with the sensor, of which every `gap`-th firing came back.
std::vector<Eigen::Vector3f> makeRing(int gap) {
  std::vector<Eigen::Vector3f> points;
  for (int column = 0; column < 1800; column += gap) {
    const double azimuth = (0.2 * column + 0.1) * kDegree;
    points.emplace_back(20.0 * std::cos(azimuth), 20.0 * std::sin(azimuth), 0.01);
  }
  return points;
}

TEST(Neighborhood, NoReturnIsTakenTwice) {
  const ScanParameters parameters;
  for (const int gap : {1, 2, 3, 5, 20}) {
    const std::vector<Eigen::Vector3f> points = makeRing(gap);
    const RangeImage image(points, parameters.horizontal_resolution * kDegree,
                           parameters.vertical_resolution * kDegree);
    const Neighborhood neighbors = collectNeighbors(image, points, 40, parameters);
    std::set<std::tuple<float, float, float>> places;
    for (int i = 0; i < neighbors.size; ++i) places.emplace(neighbors.x[i], neighbors.y[i], neighbors.z[i]);
    EXPECT_EQ(static_cast<int>(places.size()), neighbors.size) << "every " << gap << "th firing";
    EXPECT_EQ(neighbors.size > 0, gap < 20) << "every " << gap << "th firing";
  }
}

}  // namespace
}  // namespace atom_map
