// Paths of a sphere-shaped robot through a map that others may write meanwhile (paper IV-A).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "atom_mapping/planning/path_search.h"

namespace atom_map {

// Calls its argument with the map, which stands still meanwhile, such as Mapper::read does.
using ReadMap = std::function<void(const std::function<void(const AtomMap&)>&)>;

// Start and goal in the map frame, finite; the preference's lengths and weight not negative.
struct PathRequest {
  Eigen::Vector3d start;
  Eigen::Vector3d goal;
  PathPreference preference;
  double timeout = 5.0;  // s of wall time
  bool shortcut = true;
};

enum class PathOutcome { kFound, kUnknown, kOccupied, kTooTight, kNoConnection, kTimeout };

struct PlannedPath {
  PathOutcome outcome = PathOutcome::kTimeout;
  bool is_start = false;                // of a place that is unknown, occupied or too tight: it is the start
  std::vector<Eigen::Vector3d> points;  // map frame, from start to goal; empty unless found
  double length = 0.0;                  // m
  double cost = 0.0;                    // the length and what Eq. (12)'s surface term adds
  std::uint32_t expanded = 0;           // nodes
  double room = 0.0;                    // m, of a place that is too tight: from it to the nearest surface
  Eigen::Vector3d nearest;              // map frame; without a connection or time: what was reached nearest to the goal
  double seconds = 0.0;                 // of wall time
};

// What a place is to a robot of that radius (m): kFound if a path may begin or end there, or kUnknown, kOccupied or
// kTooTight. `point` in the map frame.
PathOutcome examine(const AtomMap& map, const Eigen::Vector3d& point, float robot_radius,
                    const GaussianProcessParameters& regression);

// Plans a path that is safe as clearance.h has it. Takes some milliseconds over the timeout at most: up to
// 16 where half a million atoms were searched, most of it to forget them.
//
// Choice: the map is read for some milliseconds at a time, and the whole path looked through at the end, for occupied atoms,
// unknown space and, at its points, for distances to surfaces; where the map has changed so that it does not hold, it is
// planned anew. A copy of the map would cost more than most searches do.
// Choice: a margin of 0.75 radii first; 0.4 where that finds no connection, or a path that costs over 1.05 times as
// much; and none where there is no connection otherwise. A passage that only just holds the robot is worth a small way
// round, and no large one.
PlannedPath planPath(const ReadMap& read, const PathRequest& request, const GaussianProcessParameters& regression);

}  // namespace atom_map
