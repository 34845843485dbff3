#pragma once

#include <string>

#include "atom_mapping/map/atom_map.h"

namespace atom_map {

// Writes the map as an OctoMap (.bt, one bit of occupancy a voxel), in the map frame: each voxel, of an atom's volume, is
// what the map says of its centre, and left out where that is unknown. The file is written as by writeFile. Throws
// std::runtime_error also where the map reaches farther from its frame's origin than OctoMap's 32768 voxels.
void exportOctree(const AtomMap& map, const std::string& file);

}  // namespace atom_map
