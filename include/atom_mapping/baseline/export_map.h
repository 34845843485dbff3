#pragma once

#include <string>

#include "atom_mapping/map/atom_map.h"

namespace atom_map {

// Whether exportMap knows the file's ending.
bool isExportable(const std::string& file);

// Writes a map for other programs, by the file's ending: its atoms as exportAtoms does (.ply, .pcd, .csv), or the space as
// exportOctree does (.bt). Throws as they do, std::invalid_argument for any other ending.
void exportMap(const AtomMap& map, const std::string& file);

// Throws what exportMap would if the ending is unknown or the folder is not there or takes no files: to be asked before
// hours of mapping.
void checkMapExport(const std::string& file);

}  // namespace atom_map
