#pragma once

#include <chrono>
#include <functional>
#include <vector>

#include "atom_mapping/planning/path_search.h"

namespace atom_map {

// Calls its argument with the map, which stands still meanwhile, such as Mapper::read does.
using ReadMap = std::function<void(const std::function<void(const AtomMap&)>&)>;

// What is fixed while one path is planned. Positions in the local frame that `origin` is of.
struct PathTask {
  ReadMap read;
  Eigen::Vector3d origin;  // map frame
  PathPreference preference;
  SafetyRules rules;
};

// Whether each part of a straight way, two radii long or less, passes the test, as the map is now: is_safe(clearance,
// from, to). Not when the map lost its frame. Holds the map for one part at a time.
using TestWay = std::function<bool(Clearance&, const Eigen::Vector3f&, const Eigen::Vector3f&)>;
bool passes(const PathTask& task, const Eigen::Vector3f& from, const Eigen::Vector3f& to, const TestWay& test);

// The path, or one of less cost that leaves the atoms where a straight way is safe and costs less; its points lie two
// radii apart or nearer. Stops at the deadline with what it has.
std::vector<Waypoint> shortcut(std::vector<Waypoint> path, const PathTask& task,
                               std::chrono::steady_clock::time_point deadline);

}  // namespace atom_map
