#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

#include "atom_mapping/base/floor_to_int.h"
#include "atom_mapping/base/point_blocks.h"

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

// Calls visit(i, Cell) for each i below `count`, with the cell that holds point_of(i). Quicker than one after another.
template <class PointOf, class Visit>
void forEachCell(std::size_t count, float cells_per_metre, const PointOf& point_of, Visit&& visit) {
  std::array<PointBlock<std::int32_t>, 3> cells;
  forEachPointBlock(count, point_of, [&](std::size_t begin, std::size_t size, const auto& coordinates) {
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < kPointBlock; ++i) {
        cells[axis][i] = floorToInt(coordinates[axis][i] * cells_per_metre);
      }
    }
    for (std::size_t i = 0; i < size; ++i) visit(begin + i, Cell{cells[0][i], cells[1][i], cells[2][i]});
  });
}

}  // namespace atom_map
