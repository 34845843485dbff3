#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/map/scan_report.h"
#include "atom_mapping/sim/coverage.h"

namespace atom_map {

// An atom, or a voxel.
struct MapUnit {
  Eigen::Vector3d center;  // map frame
  double size;             // m: diameter, or side
  double log_odds;         // in signed distance mode the negated distance, m
};

// A map to be compared with others, whichever it is.
struct ComparedMap {
  std::string name;  // atom_occupancy, atom_signed_distance, octomap, octomap_pruned or octomap_every_return
  std::function<ScanReport(const LidarScan&, const Pose&)> insert_scan;
  AskOccupancy ask;                      // as ~query_occupancy answers; from one thread at a time
  std::function<std::uint64_t()> units;  // atoms, or leaves of the octree
  std::function<void()> release;         // empties it and gives back the memory that it held
  // What pictures are made of. The first is what `ask` classifies; in signed distance mode the negated distance (m).
  std::function<std::optional<float>(const Eigen::Vector3d&)> log_odds = {};
  std::function<std::vector<MapUnit>()> list_units = {};
};

// Both throw std::invalid_argument that names every parameter out of its range.
ComparedMap makeAtomMap(MappingParameters parameters, Mode mode);
ComparedMap makeOctomap(const MappingParameters& parameters, const OctomapParameters& octomap);

// OctoMaps beside the one that gets what the atom maps get.
struct MoreOctomaps {
  bool pruned = false;        // that joins equal voxels as it grows
  bool every_return = false;  // whose scans are not thinned: what OctoMap's own server does
};

// Both modes of the atom map, and OctoMaps with voxels of `voxel` metres (0: of an atom's volume). Throws as those above.
std::vector<ComparedMap> makeComparedMaps(const MappingParameters& parameters, double voxel, const MoreOctomaps& more);

}  // namespace atom_map
