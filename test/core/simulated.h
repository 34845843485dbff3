// Simulated scans for tests: of small worlds made to order, and of the drives that maps are judged by.
#pragma once

#include <utility>
#include <vector>

#include "atom_mapping/sim/make_scene.h"
#include "atom_mapping/sim/simulate_scan.h"

namespace atom_map {

// One revolution of a level VLP-16 at the origin of a world.
inline SimulatedScan scanFromOrigin(std::vector<Solid> solids, const LidarModel& model) {
  const Scene scene("made to order", std::move(solids), Eigen::AlignedBox3d(Eigen::Vector3d::Zero()));
  Trajectory rest;
  rest.base_pose = [](double) { return Pose::Identity(); };
  return simulateScan(scene, rest, 0.0, model, 1);
}

// A closed room whose walls lie `half` metres from the sensor, turned about z.
inline Solid makeRoom(double half, double yaw = 0.0) {
  const Pose pose(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()));
  return {makeBox(pose, Eigen::Vector3d::Constant(2.0 * half)), SurfaceKind::kWall, true};
}

inline Solid makeUprightPole(double x, double y, double radius) {
  return {Cylinder{{x, y, -20.0}, radius, 40.0}, SurfaceKind::kPole};
}

// A drive through one of the scenes that makeScene knows, ten scans a second.
struct Drive {
  std::string scene_name;
  Scene scene;
  std::vector<SimulatedScan> simulated;
  std::vector<LidarScan> scans;  // what a mapper sees of them
  std::vector<Pose> poses;
};

inline Drive makeDrive(const std::string& scene_name, int scans, int every = 1, const LidarModel& model = {}) {
  Drive drive{scene_name, makeScene(scene_name), {}, {}, {}};
  const Trajectory trajectory = makeTrajectory(scene_name);
  for (int i = 0; i < scans * every; i += every) {
    drive.simulated.push_back(simulateScan(drive.scene, trajectory, 0.1 * i, model, 1));
    drive.scans.push_back(toLidarScan(drive.simulated.back()));
    drive.poses.push_back(trajectory.sensorPose(0.1 * i));
  }
  return drive;
}

}  // namespace atom_map
