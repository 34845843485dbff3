#include "atom_mapping/scan/directions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "atom_mapping/base/fast_atan2.h"

namespace atom_map {
namespace {

// Points are taken in blocks, coordinate by coordinate, which a compiler makes run four at once.
constexpr std::size_t kBlock = 256;
using Block = std::array<float, kBlock>;

struct Angles {
  Block elevation;
  Block azimuth;
  Block range;
};

Angles anglesOf(const Block& x, const Block& y, const Block& z) {
  Angles angles;
  for (std::size_t i = 0; i < kBlock; ++i) {
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
  Block x{};
  Block y{};
  Block z{};
  for (std::size_t begin = 0; begin < points.size(); begin += kBlock) {
    const std::size_t count = std::min(kBlock, points.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = points[begin + i].x();
      y[i] = points[begin + i].y();
      z[i] = points[begin + i].z();
    }
    const Angles angles = anglesOf(x, y, z);
    std::copy_n(angles.elevation.data(), count, directions.elevation.data() + begin);
    std::copy_n(angles.azimuth.data(), count, directions.azimuth.data() + begin);
    std::copy_n(angles.range.data(), count, directions.range.data() + begin);
  }
  return directions;
}

}  // namespace atom_map
