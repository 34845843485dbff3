#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/scan/filter.h"
#include "atom_mapping/scan/range_image.h"

namespace atom_map {

// The neighbours of one return, relative to it: some of its own ring and of two above and below, as far apart as a support
// in space asks for. Nearer ones weigh more.
struct Neighborhood {
  static constexpr int kRingsBeside = 2;    // above and below
  static constexpr int kSamplesBeside = 4;  // left and right on each ring
  static constexpr int kRows = 2 * kRingsBeside + 1;
  static constexpr int kColumns = 2 * kSamplesBeside + 1;
  static constexpr int kPlaces = (kRows * kColumns + 3) / 4 * 4;  // whole vector registers
  using Floats = Eigen::Array<float, kPlaces, 1>;
  Floats weight = Floats::Zero();  // 0 where there is no neighbour
  Floats x, y, z;                  // m
  Floats per_tolerance;            // 1 / m
  int size = 0;
  std::array<std::array<int, kColumns>, kRows> index;  // of a row and column, or -1

  Neighborhood() : x(weight), y(weight), z(weight), per_tolerance(weight) {
    for (auto& row : index) row.fill(-1);
  }

  Eigen::Vector3f offset(int i) const { return {x[i], y[i], z[i]}; }
  bool agrees(int i, const Eigen::Vector3f& normal) const {
    return std::abs(offset(i).dot(normal)) * per_tolerance[i] <= 1.0F;
  }
};

// Of the return `ray` of the scan that the image shows.
Neighborhood collectNeighbors(const FilteredScan& scan, const RangeImage& image, std::uint32_t ray,
                              const ScanParameters& parameters);

}  // namespace atom_map
