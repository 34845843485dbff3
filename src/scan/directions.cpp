#include "atom_mapping/scan/directions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "atom_mapping/base/fast_atan2.h"
#include "atom_mapping/base/point_blocks.h"

namespace atom_map {
namespace {

using Block = PointBlock<float>;

struct Angles {
  Block elevation;
  Block azimuth;
  Block range;
};

Angles anglesOf(const Block& x, const Block& y, const Block& z) {
  Angles angles;
  for (std::size_t i = 0; i < kPointBlock; ++i) {
    const float squared = x[i] * x[i] + y[i] * y[i];
    angles.elevation[i] = fastAtan2(z[i], std::sqrt(squared));
    angles.azimuth[i] = fastAtan2(y[i], x[i]);
    angles.range[i] = std::sqrt(squared + z[i] * z[i]);
  }
  return angles;
}

}  // namespace

Directions directionsOf(const std::vector<Eigen::Vector3f>& points) {
  Directions directions;
  for (auto* of : {&directions.elevation, &directions.azimuth, &directions.range}) of->resize(points.size());
  forEachPointBlock(
      points.size(), [&](std::size_t i) -> const Eigen::Vector3f& { return points[i]; },
      [&](std::size_t begin, std::size_t count, const std::array<Block, 3>& coordinates) {
        const Angles angles = anglesOf(coordinates[0], coordinates[1], coordinates[2]);
        std::copy_n(angles.elevation.data(), count, directions.elevation.data() + begin);
        std::copy_n(angles.azimuth.data(), count, directions.azimuth.data() + begin);
        std::copy_n(angles.range.data(), count, directions.range.data() + begin);
      });
  return directions;
}

}  // namespace atom_map
