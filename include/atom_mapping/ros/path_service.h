#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <tf2/buffer_core.h>

#include "atom_mapping/PlanPath.h"
#include "atom_mapping/planning/plan_path.h"
#include "atom_mapping/ros/scan_server.h"

namespace atom_mapping {

// Plans paths for the node. Never throws: where there is no path, the answer's message says why.
// Thread safety: may be called from several threads at once. Takes hold of the map for milliseconds at a time.
class PathService {
 public:
  static constexpr float kLargestLength =
      32.0F;  // atomic radii, of a robot's radius and of q; larger would hold scans up
  static constexpr float kLongestTime = 3600.0F;  // s

  PathService(const ScanServer& server, const tf2::BufferCore& transforms) : server_(server), transforms_(transforms) {}

  // Start and goal in any frames that tf knows, as it knows them last. The path is in the map frame, its stamp that of
  // the newest scan; x points along the way, at the end as the goal says, if it says.
  PlanPath::Response answer(const PlanPath::Request& request) const;

  // The same from where the sensor was last, by the node's own parameters.
  // Choice: rviz's 2D Nav Goal has no height. A goal at z = 0 where the robot cannot be is moved up or down, to the
  // nearest to the sensor's height where it can.
  PlanPath::Response answerGoal(const geometry_msgs::PoseStamped& goal) const;

 private:
  void fill(const PlanPath::Request& request, PlanPath::Response& response) const;
  PlanPath::Request requestFor(const geometry_msgs::PoseStamped& goal) const;
  void liftGoal(double height, PlanPath::Request& request) const;

  const ScanServer& server_;
  const tf2::BufferCore& transforms_;
};

}  // namespace atom_mapping
