#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>

namespace atom_map {

// Points that are taken in blocks, coordinate by coordinate, which a compiler makes run four at once.
constexpr std::size_t kPointBlock = 256;
template <class Number>
using PointBlock = std::array<Number, kPointBlock>;  // a number of each point

// Calls visit(begin, size, {x, y, z}) for one block after another of point_of(0) to point_of(count - 1): of the coordinates,
// which always fill a block, the first `size` are those of the points from `begin` on.
template <class PointOf, class Visit>
void forEachPointBlock(std::size_t count, const PointOf& point_of, Visit&& visit) {
  std::array<PointBlock<float>, 3> coordinates{};
  for (std::size_t begin = 0; begin < count; begin += kPointBlock) {
    const std::size_t size = std::min(kPointBlock, count - begin);
    for (std::size_t i = 0; i < size; ++i) {
      const Eigen::Vector3f& point = point_of(begin + i);
      for (int axis = 0; axis < 3; ++axis) coordinates[axis][i] = point[axis];
    }
    visit(begin, size, coordinates);
  }
}

}  // namespace atom_map
