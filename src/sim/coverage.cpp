#include "atom_mapping/sim/coverage.h"

#include "atom_mapping/base/random.h"

namespace atom_map {

bool isInRange(const Eigen::Vector3f& point, const ScanParameters& parameters) {
  const double range = point.cast<double>().norm();
  return range >= parameters.min_range && range <= parameters.max_range;
}

void addRays(const LidarScan& scan, const Pose& sensor, const ScanParameters& parameters, std::size_t stride,
             std::vector<ObservedRay>& rays) {
  for (std::size_t i = 0; i < scan.points.size(); i += stride) {
    const Eigen::Vector3f& point = scan.points[i];
    if (isInRange(point, parameters)) rays.push_back({sensor.translation(), sensor * point.cast<double>(), {}, false});
  }
}

void addRays(const SimulatedScan& scan, const Pose& sensor, const ScanParameters& parameters, std::size_t stride,
             std::vector<ObservedRay>& rays) {
  for (std::size_t i = 0; i < scan.returns.size(); i += stride) {
    const SimulatedReturn& r = scan.returns[i];
    if (!isInRange(r.point, parameters)) continue;
    const Eigen::Vector3d normal = sensor.linear() * r.true_normal.cast<double>();
    rays.push_back({sensor.translation(), sensor * r.point.cast<double>(), normal, isThin(r.kind)});
  }
}

Coverage measureCoverage(const std::vector<ObservedRay>& rays, double radius, const AskOccupancy& ask,
                         const AskTrueDistance& true_distance, std::uint64_t seed) {
  Coverage coverage;
  Random random(seed);
  for (const ObservedRay& ray : rays) {
    const Eigen::Vector3d along = ray.end - ray.sensor;
    const double range = along.norm();
    const Eigen::Vector3d direction = along / range;
    const double drawn = random.uniform();
    coverage.surface.count(ask(ray.end - radius * ray.normal.value_or(-direction)) == Occupancy::kOccupied);
    if (ray.thin) coverage.thin.count(ask(ray.end) == Occupancy::kOccupied);

    if (range <= 2.0 * radius) continue;
    const Eigen::Vector3d point = ray.sensor + drawn * (range - 2.0 * radius) * direction;
    if (true_distance && true_distance(point) < radius) continue;
    const Occupancy occupancy = ask(point);
    coverage.free.count(occupancy == Occupancy::kFree);
    coverage.false_occupied.count(occupancy == Occupancy::kOccupied);
    coverage.unknown.count(occupancy == Occupancy::kUnknown);
  }
  return coverage;
}

}  // namespace atom_map
