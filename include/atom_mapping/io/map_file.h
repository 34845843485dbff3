// The map file (.h5): a map and all that shaped it, in HDF5 that any HDF5 program reads.
//
//   /             attributes: format_version, scans, atoms, known_planes (how many), origin (m, map frame)
//   /parameters   attributes: every parameter by its name, such as mode, radius, map_frame, scan/max_range
//   /centers      float32 [atoms, 3], m, from the origin and parallel to the map frame
//   /log_odds     float32 [atoms], in occupancy mode
//   /signed_distance, /variance    float32 [atoms], m and m^2, in signed distance mode
//   /known_planes    float32 [planes, 8], what the last scan tells the next of flat surfaces: KnownPlane's members; may be missing
//
// Atoms lie in the tree's order: a map that is loaded equals the one that was saved, bit by bit and in every answer, and
// gives the same file again. Two threads may save or load at once.
#pragma once

#include <cstdint>
#include <string>

#include "atom_mapping/map/atom_map.h"
#include "atom_mapping/map/map_copy.h"

namespace atom_map {

struct LoadedMap {
  MappingParameters parameters;  // that it was made by
  std::uint64_t scans;           // that it was made of
  AtomMap map;
};

// As writeFile: a kill or a full disk at any moment leaves the old file whole.
void saveMap(const MapCopy& map, const std::string& file);

// Throws std::runtime_error, with file and reason, unless the file is whole and all that it holds can be: every number
// finite and within its range, every atom within the clamps and clear of the others. A parameter that the file lacks, since it
// is older than the parameter, has its default.
LoadedMap loadMap(const std::string& file);

}  // namespace atom_map
