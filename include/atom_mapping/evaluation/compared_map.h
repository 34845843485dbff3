#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/map/scan_report.h"
#include "atom_mapping/sim/coverage.h"

namespace atom_map {

// A map to be compared with others, whichever it is.
struct ComparedMap {
  std::string name;  // atom_occupancy, atom_signed_distance or octomap
  std::function<ScanReport(const LidarScan&, const Pose&)> insert_scan;
  AskOccupancy ask;                      // as ~query_occupancy answers; from one thread at a time
  std::function<std::uint64_t()> units;  // atoms, or leaves of the octree
  std::function<void()> release;         // empties it and gives back the memory that it held
};

// Both throw std::invalid_argument that names every parameter out of its range.
ComparedMap makeAtomMap(MappingParameters parameters, Mode mode);
ComparedMap makeOctomap(const MappingParameters& parameters, const OctomapParameters& octomap);

}  // namespace atom_map
