#include "atom_mapping/sim/trajectory.h"

#include <cmath>
#include <utility>
#include <vector>

#include "atom_mapping/base/angles.h"
#include "atom_mapping/sim/make_scene.h"

namespace atom_map {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double kSecondsPerPoint = 7.0;  // control points lie 8 or 9 m apart

struct Motion {
  Vector3d position;
  Vector3d velocity;
};

// Closed uniform cubic B-spline: its second derivative is continuous, and it stays within its control points' hull.
Motion followSpline(const std::vector<Vector3d>& points, double time) {
  const double u = time / kSecondsPerPoint;
  const double cell = std::floor(u);
  const double t = u - cell;
  const long count = static_cast<long>(points.size());
  const long first = ((static_cast<long>(cell) % count) + count) % count;
  const auto at = [&](long i) { return points[static_cast<std::size_t>((first + i) % count)]; };
  const Eigen::Vector4d weight(std::pow(1.0 - t, 3), 3.0 * t * t * t - 6.0 * t * t + 4.0,
                               -3.0 * t * t * t + 3.0 * t * t + 3.0 * t + 1.0, t * t * t);
  const Eigen::Vector4d slope(-(1.0 - t) * (1.0 - t), 3.0 * t * t - 4.0 * t, -3.0 * t * t + 2.0 * t + 1.0, t * t);
  Motion motion{Vector3d::Zero(), Vector3d::Zero()};
  for (int i = 0; i < 4; ++i) {
    motion.position += weight[i] / 6.0 * at(i);
    motion.velocity += slope[i] / (2.0 * kSecondsPerPoint) * at(i);
  }
  return motion;
}

// Nose along the path, with the slow sway of a wheeled robot.
Pose drive(const std::vector<Vector3d>& points, double time) {
  const Motion motion = followSpline(points, time);
  const double yaw = std::atan2(motion.velocity.y(), motion.velocity.x());
  const double climb = std::atan2(motion.velocity.z(), motion.velocity.head<2>().norm());
  const double roll = 0.8 * kDegree * std::sin(3.1 * time);
  const double pitch = 0.6 * kDegree * std::sin(4.3 * time) - climb;
  return Eigen::Translation3d(motion.position) * AngleAxisd(yaw, Vector3d::UnitZ()) * mountRotation(roll, pitch);
}

Pose tumble(double time) {
  const Vector3d position(0.2 * std::sin(0.9 * time), 0.16 * std::sin(1.3 * time), 0.12 * std::sin(1.7 * time));
  return Eigen::Translation3d(position) * AngleAxisd(1.2 * time, Vector3d::UnitX()) *
         AngleAxisd(0.25 * std::sin(1.1 * time), Vector3d::UnitY()) * AngleAxisd(0.4 * time, Vector3d::UnitZ());
}

// Control points counter-clockwise around a rectangle, starting on its south side.
std::vector<Vector3d> ring(double half_x, double half_y, int along_x, int along_y) {
  std::vector<Vector3d> points;
  const Vector3d corners[] = {{-half_x, -half_y, 0}, {half_x, -half_y, 0}, {half_x, half_y, 0}, {-half_x, half_y, 0}};
  for (int side = 0; side < 4; ++side) {
    const int count = side % 2 == 0 ? along_x : along_y;
    for (int i = 0; i < count; ++i) {
      points.emplace_back(corners[side] + (corners[(side + 1) % 4] - corners[side]) * i / count);
    }
  }
  return points;
}

Trajectory makeDrive(std::vector<Vector3d> points, double height) {
  Trajectory trajectory;
  trajectory.base_pose = [points = std::move(points)](double time) { return drive(points, time); };
  trajectory.mount = Eigen::Translation3d(0.0, 0.0, height) * mountRotation(1.5 * kDegree, 3.0 * kDegree);
  return trajectory;
}

}  // namespace

Eigen::Quaterniond mountRotation(double roll, double pitch) {
  return AngleAxisd(pitch, Vector3d::UnitY()) * AngleAxisd(roll, Vector3d::UnitX());
}

Trajectory makeTrajectory(const std::string& scene_name) {
  if (scene_name == "hall") return makeDrive(ring(18.0, 13.5, 4, 3), 1.4);
  if (scene_name == "campus") {
    std::vector<Vector3d> points = ring(45.0, 16.0, 10, 4);
    for (Vector3d& point : points) point.z() = campusGroundHeight(point.x(), point.y());
    return makeDrive(std::move(points), 1.6);
  }
  makeScene(scene_name);  // throws for an unknown name
  return {tumble, Pose::Identity()};
}

}  // namespace atom_map
