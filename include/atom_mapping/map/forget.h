// What a map forgets as its robot moves on; the paper keeps all.
//
// Choice: what is forgotten follows from the map, the parameters and the sensor's place alone, not from what was forgotten
// before. So the same scans give the same map, and a map that was saved and loaded goes on as if it had never stopped; but
// limits/max_megabytes counts the memory that the tree keeps for atoms to come, of which a loaded map has less.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "atom_mapping/map/atom_map.h"
#include "atom_mapping/map/map_limit.h"

namespace atom_map {

// In the map's local frame. What lies beyond is forgotten.
struct KeptBall {
  Eigen::Vector3f center;
  float radius;  // m
};

// Of limits/window. `sensor` in the map frame.
// Choice: the ball's centre is that of a cell of space in which the sensor is, so that it forgets some metres at a time. The ball
// holds the window of any sensor in the cell and reaches kWindowSlack windows beyond it at most.
constexpr double kWindowSlack = 0.125;
KeptBall windowAround(const AtomMap& map, double window, const Eigen::Vector3d& sensor);

// About the sensor, that leaves kKeptShare of the limit; nothing while the limit holds.
// Choice: that share, so that a robot that explores forgets once in many scans.
constexpr double kKeptShare = 0.95;
std::optional<KeptBall> ballOfNearest(const AtomMap& map, const MapLimit& limit, const Eigen::Vector3d& sensor);

// Removes those farthest from `place`, in the map frame, until the limit holds; returns how many.
std::size_t forgetFarthest(AtomMap& map, const MapLimit& limit, const Eigen::Vector3d& place);

// The radius (m) about p within which `count` atoms lie, or fewer where several lie as far as the next. count < tree.size().
// Takes no memory that grows with the tree.
float radiusOfNearest(const AtomTree& tree, const Eigen::Vector3f& p, std::size_t count);

}  // namespace atom_map
