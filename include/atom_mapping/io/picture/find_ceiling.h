// Whether a map is of an interior that a bird's eye cannot look into.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace atom_map {

// Height (m) beneath which no atom belongs to the ceiling; no value where the map has none. A ceiling is a level, 2 m
// or more above the floor, whose atoms lie over at least a quarter of the area that the map covers.
// Centres must be finite, and there must be one.
std::optional<float> findCeiling(const std::vector<Eigen::Vector3f>& centers, float radius);

}  // namespace atom_map
