#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>

#include "atom_mapping/map/atom_map.h"

namespace atom_mapping {

// Of a map that was not made scan by scan: one beyond limits/max_* is refused or cut, as limits/policy says. Returns how many
// atoms it forgot, those farthest from `place` in the map frame. Throws std::runtime_error that begins with `fault`, such as
// "cannot load map.h5".
std::size_t fitToLimits(const std::string& fault, const atom_map::LimitParameters& limits, const Eigen::Vector3d& place,
                        atom_map::AtomMap& map);

}  // namespace atom_mapping
