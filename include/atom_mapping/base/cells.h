#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "atom_mapping/base/floor_to_int.h"

namespace atom_map {

// A cubic cell: coordinates in cells.
struct Cell {
  std::int32_t x;
  std::int32_t y;
  std::int32_t z;
};

inline Cell cellOf(const Eigen::Vector3f& point, float cells_per_metre) {
  const auto along = [&](int axis) { return floorToInt(point[axis] * cells_per_metre); };
  return {along(0), along(1), along(2)};
}

// Calls visit(i, Cell) for each i below `count`, with the cell that holds point_of(i). Quicker than one after another: points are
// taken in blocks, coordinate by coordinate, which a compiler makes run four at once.
template <class PointOf, class Visit>
void forEachCell(std::size_t count, float cells_per_metre, const PointOf& point_of, Visit&& visit) {
  constexpr std::size_t kBlock = 256;
  std::array<std::array<float, kBlock>, 3> coordinates{};
  std::array<std::array<std::int32_t, kBlock>, 3> cells;
  for (std::size_t begin = 0; begin < count; begin += kBlock) {
    const std::size_t size = std::min(kBlock, count - begin);
    for (std::size_t i = 0; i < size; ++i) {
      const Eigen::Vector3f& point = point_of(begin + i);
      for (int axis = 0; axis < 3; ++axis) coordinates[axis][i] = point[axis];
    }
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < kBlock; ++i) cells[axis][i] = floorToInt(coordinates[axis][i] * cells_per_metre);
    }
    for (std::size_t i = 0; i < size; ++i) visit(begin + i, Cell{cells[0][i], cells[1][i], cells[2][i]});
  }
}

}  // namespace atom_map
