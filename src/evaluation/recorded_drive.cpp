#include "atom_mapping/evaluation/recorded_drive.h"

#include "atom_mapping/base/angles.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

constexpr double kGroundHeight = 0.1;  // m; at 0 lies the border of two voxels
constexpr double kSensorHeight = 1.6;  // m above the ground
constexpr double kSpeed = 1.0;         // m/s

// Slope frame to map frame.
Pose slopePose(double degrees) {
  return Eigen::Translation3d(0.0, 0.0, kGroundHeight) * mountRotation(0.0, -degrees * kDegree);
}

}  // namespace

RecordedDrive recordDrive(const Scene& scene, const Trajectory& trajectory, const LidarModel& model, int scans,
                          std::uint64_t seed, const ScanParameters& parameters, std::size_t stride) {
  RecordedDrive drive;
  for (int i = 0; i < scans; ++i) {
    const double stamp = model.period * i;
    const SimulatedScan scan = simulateScan(scene, trajectory, stamp, model, seed);
    const Pose pose = trajectory.sensorPose(stamp);
    drive.scans.push_back(toLidarScan(scan));
    drive.poses.push_back(pose);
    addRays(scan, pose, parameters, stride, drive.rays);
  }
  return drive;
}

Scene makeSlope(double degrees) {
  const Pose pose = slopePose(degrees);
  const Plane ground(Vector3d(-pose.linear().col(2)), Vector3d(pose.translation()));
  return Scene("slope", {{ConvexPolyhedron({ground}), SurfaceKind::kGround, true}},
               {Vector3d(-30.0, -30.0, -15.0), Vector3d(30.0, 30.0, 15.0)});
}

Trajectory makeClimb(double degrees) {
  Trajectory climb;
  climb.base_pose = [degrees](double time) -> Pose {
    return slopePose(degrees) * Eigen::Translation3d(kSpeed * time, 0.0, 0.0);
  };
  climb.mount = Pose(Eigen::Translation3d(0.0, 0.0, kSensorHeight));
  return climb;
}

Share measureGroundKept(const std::vector<ObservedRay>& rays, double radius, const AskOccupancy& ask) {
  Share kept;
  for (const ObservedRay& ray : rays) {
    const auto is_occupied = [&](double depth) {
      return ask(ray.end - depth * ray.normal.value()) == Occupancy::kOccupied;
    };
    kept.count(is_occupied(0.0) || is_occupied(0.5 * radius) || is_occupied(radius));
  }
  return kept;
}

}  // namespace atom_map
