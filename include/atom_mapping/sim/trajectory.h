#pragma once

#include <functional>
#include <string>

#include "atom_mapping/base/types.h"

namespace atom_map {

// A drive through a scene. Times are seconds since its start; any time will do, also a negative one, since a drive is a
// loop. Keeps 0.6 m or more from every surface.
struct Trajectory {
  std::function<Pose(double time)> base_pose;  // base frame (x forward, z up; on the ground where there is one) to map
  Pose mount = Pose::Identity();               // sensor frame to base frame

  Pose sensorPose(double time) const { return base_pose(time) * mount; }
};

// Rotation sensor to base: roll about x, then pitch about y (positive: nose down), radians.
Eigen::Quaterniond mountRotation(double roll, double pitch);

// hall, campus: some 1.3 m/s around the scene, the sensor 1.4 and 1.6 m over the ground on a mount that is not level
// (1.5 deg of roll, 3 deg of pitch). The closed scenes: within 0.3 m of the centre, tumbling, so that 4 s of scans
// cover the whole surface. Throws std::invalid_argument for a scene that makeScene does not know.
Trajectory makeTrajectory(const std::string& scene_name);

}  // namespace atom_map
