#pragma once

#include <string>
#include <vector>

#include "atom_mapping/base/parameters.h"

namespace atom_map {

// A line for each fault, with the parameter's name, its value and what is permitted; empty when all is well.
std::vector<std::string> findFaults(const MappingParameters& parameters);

// Throws std::invalid_argument with all faults.
void throwIfFaulty(const MappingParameters& parameters);

}  // namespace atom_map
