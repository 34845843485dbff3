#include "atom_mapping/sim/simulate_scan.h"

#include <algorithm>
#include <cmath>

#include "atom_mapping/base/angles.h"
#include "atom_mapping/base/random.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

// One laser's shot, sensor frame.
struct Shot {
  Vector3d direction;
  double time;  // s after the stamp
  std::uint16_t ring;
  std::uint16_t firing;
};

// Box and Muller 1958.
double drawGaussian(Random& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - static_cast<double>(random.uniform())));
  return radius * std::cos(2.0 * kPi * static_cast<double>(random.uniform()));
}

Random makeRandom(std::uint64_t seed, double stamp) {
  return Random(mixBits(seed) ^ static_cast<std::uint64_t>(std::llround(stamp * 1e6)));
}

// A VLP-16 fires its lower and its upper half in turn: -15, 1, -13, 3, ... degrees.
int ringOfLaser(int laser, int rings) {
  return laser % 2 == 0 ? laser / 2 : (rings + 1) / 2 + laser / 2;
}

Shot makeShot(const LidarModel& model, int firing, int ring) {
  const double azimuth = kPi - 2.0 * kPi * firing / model.firings;
  const double elevation = (model.lowest + model.ring_spacing * ring) * kPi / 180.0;
  const Vector3d direction(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                           std::sin(elevation));
  const double time = model.motion_distortion ? model.period * (firing + 1 - model.firings) / model.firings : 0.0;
  return {direction, time, static_cast<std::uint16_t>(ring), static_cast<std::uint16_t>(firing)};
}

double reflectivity(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::kGround:
      return 25.0;
    case SurfaceKind::kWall:
      return 70.0;
    case SurfaceKind::kColumn:
      return 60.0;
    case SurfaceKind::kPole:
      return 160.0;
    case SurfaceKind::kTrunk:
      return 40.0;
    case SurfaceKind::kTree:
      return 50.0;
    case SurfaceKind::kBox:
      return 80.0;
    case SurfaceKind::kCar:
      return 110.0;
    case SurfaceKind::kRamp:
      return 35.0;
  }
  return 0.0;
}

SimulatedReturn makeReturn(const Shot& shot, const Hit& hit, const Vector3d& normal, double noise) {
  const double facing = std::abs(shot.direction.dot(normal));
  const double range = std::max(hit.range + noise, 1e-3);
  return {(range * shot.direction).cast<float>(),
          (hit.range * shot.direction).cast<float>(),
          normal.cast<float>(),
          hit.kind,
          static_cast<float>(reflectivity(hit.kind) * (0.3 + 0.7 * facing)),
          static_cast<float>(shot.time),
          shot.ring,
          shot.firing};
}

}  // namespace

SimulatedScan simulateScan(const Scene& scene, const Trajectory& trajectory, double stamp, const LidarModel& model,
                           std::uint64_t seed) {
  Random random = makeRandom(seed, stamp);
  SimulatedScan scan;
  scan.returns.reserve(static_cast<std::size_t>(model.firings * model.rings));
  Pose pose = trajectory.sensorPose(stamp);
  for (int firing = 0; firing < model.firings; ++firing) {
    for (int laser = 0; laser < model.rings; ++laser) {
      const Shot shot = makeShot(model, firing, ringOfLaser(laser, model.rings));
      if (model.motion_distortion && laser == 0) pose = trajectory.sensorPose(stamp + shot.time);
      const double noise = model.noise_sigma * drawGaussian(random);
      const bool lost =
          random.uniform() < model.dropout;  // both drawn for every shot, so that options do not shift them
      const auto hit = scene.castRay(pose.translation(), pose.linear() * shot.direction, model.max_range);
      if (lost || !hit || hit->range < model.min_range) {
        scan.no_returns.push_back(
            {shot.direction.cast<float>(), static_cast<float>(shot.time), shot.ring, shot.firing});
      } else {
        scan.returns.push_back(makeReturn(shot, *hit, pose.linear().transpose() * hit->normal, noise));
      }
    }
  }
  return scan;
}

LidarScan toLidarScan(const SimulatedScan& scan) {
  LidarScan plain;
  plain.points.reserve(scan.returns.size());
  plain.no_returns.reserve(scan.no_returns.size());
  for (const SimulatedReturn& r : scan.returns) plain.points.push_back(r.point);
  for (const SimulatedNoReturn& r : scan.no_returns) plain.no_returns.push_back(r.direction);
  return plain;
}

}  // namespace atom_map
