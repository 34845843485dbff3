// What a scan costs as the map grows: a drive through copies of a scene that lie side by side.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "atom_mapping/base/spread.h"
#include "atom_mapping/evaluation/recorded_drive.h"
#include "atom_mapping/map/mapper.h"

namespace atom_map {

// The scans of one copy of the scene.
struct GrowthStep {
  std::uint64_t atoms = 0;  // in the map, after them
  std::uint64_t bytes = 0;
  Spread milliseconds;           // CPU time a scan
  double slowest = 0.0;          // of them, ms of CPU time
  double slowest_merging = 0.0;  // ms of wall time, which readers may wait for at the very most
};

// Where copy i of a scene lies, metres: side by side in a square of `copies`, `spacing` apart.
Eigen::Vector3d placeOfCopy(std::size_t i, std::size_t copies, double spacing);

// Maps the drive in one copy after another until the map holds `least_atoms`, and calls report(step) after each.
std::vector<GrowthStep> growMap(const RecordedDrive& drive, double spacing, std::uint64_t least_atoms, Mapper& mapper,
                                const std::function<void(const GrowthStep&)>& report);

nlohmann::ordered_json toJson(const GrowthStep& step);

}  // namespace atom_map
