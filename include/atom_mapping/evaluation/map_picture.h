// What pictures of a map are drawn from.
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>

#include "atom_mapping/evaluation/compared_map.h"

namespace atom_map {

// Every unit as [x, y, z, size, log-odds].
nlohmann::ordered_json unitsToJson(const ComparedMap& map);

// Log-odds in the plane z = 0, at steps of a tenth of a radius from three radii before to three behind the bounds' x and y:
// {"min": [x, y], "step", "rows": [[...], ...]} with the rows from the least y, null where unknown.
nlohmann::ordered_json sliceToJson(const ComparedMap& map, const Eigen::AlignedBox3d& bounds, double radius);

}  // namespace atom_map
