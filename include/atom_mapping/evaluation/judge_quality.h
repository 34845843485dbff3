#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "atom_mapping/evaluation/compared_map.h"
#include "atom_mapping/evaluation/recorded_drive.h"
#include "atom_mapping/sim/scene.h"

namespace atom_map {

// Distances from a surface within which judgeQuality judges maps of the scene, m.
std::vector<double> judgedDistances(const Scene& scene, double radius);

// How true a map is next to surfaces, one entry a distance. Of a closed scene, whose every surface the sensor sees: "Q",
// "F" (Eq. 13) and their standard errors "Q_error", "F_error". Of an open one "near_free", "near_false_free" and their
// errors: the same next to what was seen.
nlohmann::ordered_json judgeQuality(const Scene& scene, const RecordedDrive& drive, double radius,
                                    const ComparedMap& map);

}  // namespace atom_map
