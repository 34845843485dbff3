#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/scan/range_image.h"

namespace atom_map {

// The neighbours of one return, relative to it: some of its own ring and of two above and below, as far apart as a support
// in space asks for. Nearer ones weigh more. Places that are not used lie in the return itself and weigh nothing.
struct Neighborhood {
  static constexpr int kRingsBeside = 2;    // above and below
  static constexpr int kSamplesBeside = 4;  // left and right on each ring
  static constexpr int kRows = 2 * kRingsBeside + 1;
  static constexpr int kColumns = 2 * kSamplesBeside + 1;
  static constexpr int kPlaces = (kRows * kColumns + 3) / 4 * 4;  // whole vector registers
  using Floats = Eigen::Array<float, kPlaces, 1>;
  Floats weight;
  Floats x = Floats::Zero(), y = Floats::Zero(), z = Floats::Zero();  // m
  Floats per_tolerance;  // 1 / m, of the distance from a plane on which a neighbour is said to lie
  int size = 0;
  std::array<std::array<int, kColumns>, kRows> index;  // of a row and column, or -1

  Eigen::Vector3f offset(int i) const { return {x[i], y[i], z[i]}; }
  // Of each neighbour, along the normal.
  auto along(const Eigen::Vector3f& normal) const { return x * normal.x() + y * normal.y() + z * normal.z(); }
};

// Of the return points[ray]; `image` is that of the points.
Neighborhood collectNeighbors(const RangeImage& image, const std::vector<Eigen::Vector3f>& points, std::uint32_t ray,
                              const ScanParameters& parameters);

}  // namespace atom_map
