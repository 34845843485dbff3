#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "atom_mapping/map/mapper.h"

namespace atom_map {

// A map in plain columns, to be saved while mapping goes on.
struct MapCopy {
  MappingParameters parameters;                      // that shaped it; mode, radius and frame among them
  std::uint64_t scans = 0;                           // that it was made of
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // m, map frame

  // x, y, z of the centres (m, from the origin), then the values as AtomMap's; the last is empty in occupancy mode. A
  // row an atom, in the tree's order.
  std::array<std::vector<float>, 5> columns;

  std::vector<KnownPlane> planes;  // as AtomMap's

  std::size_t size() const { return columns[0].size(); }
};

// Waits for a scan that is being merged; holds the next up while it copies, 4 to 5 ms for a million atoms.
MapCopy copyMap(const Mapper& mapper);

}  // namespace atom_map
