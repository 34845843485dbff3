// Whether a map that was loaded is of the node's kind: its mode, radius and frame.
#pragma once

#include <string>

#include "atom_mapping/base/parameters.h"

namespace atom_mapping {

// Throws std::runtime_error, with the remedy, unless the file's map is in the node's map frame.
void checkFrame(const std::string& file, const atom_map::MappingParameters& theirs,
                const atom_map::MappingParameters& ours);

// Throws what a file of another mode or radius than a node's map that holds atoms is refused with.
[[noreturn]] void refuseKind(const std::string& file, const atom_map::MappingParameters& theirs,
                             const atom_map::MappingParameters& ours);

// Mode and radius, for a person.
std::string describeKind(const atom_map::MappingParameters& parameters);

}  // namespace atom_mapping
