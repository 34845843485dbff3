// The atoms of a map as a file for viewers and scripts.
#pragma once

#include <string>

#include "atom_mapping/map/atom_map.h"

namespace atom_map {

// Whether exportAtoms knows the file's extension.
bool isAtomFile(const std::string& file);

// Writes every atom, in the map frame and metres, by the file's extension: .ply (binary little endian, the radius also
// as a comment `radius R`), .pcd (binary) or .csv. Columns: x y z radius log_odds, or x y z radius signed_distance
// variance. All are float; x y z are double where the map lies more than 10 km from its frame's origin, for a float
// would round them by a millimetre there. In CSV x y z have four decimals.
//
// The file appears, or takes the place of an old one, when it is whole. Throws std::invalid_argument for any other
// extension, std::runtime_error with file and reason when it cannot be written.
void exportAtoms(const AtomMap& map, const std::string& file);

}  // namespace atom_map
