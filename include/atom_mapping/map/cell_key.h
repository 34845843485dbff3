// Cell coordinates of a point, compared as the bits of their Morton code are: from the highest, x before y before z.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace atom_map {

struct CellKey {
  static constexpr std::uint32_t kOffset = 1U << 31;  // cell 0 of the map; keeps negative coordinates in order

  std::array<std::uint32_t, 3> cell;

  CellKey(const Eigen::Vector3f& p, float cells_per_metre) : cell{} {
    for (int axis = 0; axis < 3; ++axis) cell[axis] = cellOf(p[axis], cells_per_metre);
  }

  // Never decreases as the coordinate grows, so that a search may prune by keys without a rounding error. All that lies
  // beyond 2^30 cells is in the outermost cell.
  static std::uint32_t cellOf(float coordinate, float cells_per_metre) {
    const float cell = std::clamp(std::floor(coordinate * cells_per_metre), -0x1p30F, 0x1p30F);
    return kOffset + static_cast<std::uint32_t>(static_cast<std::int32_t>(cell));
  }

  // Level of the coarsest dyadic plane between two cells: 3 * bit + 2 - axis, or -1 for the same cell.
  static int firstDifference(const CellKey& a, const CellKey& b) {
    int level = -1;
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t difference = a.cell[axis] ^ b.cell[axis];
      if (difference == 0) continue;
      const int bit = 31 - __builtin_clz(difference);
      level = std::max(level, 3 * bit + 2 - axis);
    }
    return level;
  }

  static int axisOf(int level) { return 2 - level % 3; }

  // The plane of a split at `level` beside this cell, in cells from the map's origin.
  std::int32_t planeAt(int level) const {
    const std::uint32_t bit = 1U << (level / 3);
    return static_cast<std::int32_t>(((cell[axisOf(level)] & ~(bit - 1U)) | bit) - kOffset);
  }
};

}  // namespace atom_map
