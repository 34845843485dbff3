#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Path.h>

#include <optional>
#include <string>

#include "atom_mapping/planning/plan_path.h"

namespace atom_mapping {

// A path whose poses look along it (x forward, z as far up as that permits), and at its end as told.
nav_msgs::Path toMessage(const atom_map::PlannedPath& path, const std_msgs::Header& header,
                         const std::optional<Eigen::Quaterniond>& final_orientation);

// Why there is no path, and what to do, for a person.
std::string whyNot(const atom_map::PlannedPath& path, const atom_map::PathRequest& request);

}  // namespace atom_mapping
