#include "atom_mapping/baseline/octomap_mapper.h"

#include "atom_mapping/base/check_parameters.h"
#include "atom_mapping/base/timed.h"

namespace atom_map {
namespace {

// Rays without an echo are told to OctoMap as returns from beyond its range.
constexpr double kBeyondRange = 1.01;

// Those that are traced and, if asked, the rays without an echo.
std::vector<Eigen::Vector3f> raysOf(const FilteredScan& filtered, const LidarScan& scan,
                                    const ScanParameters& parameters) {
  std::vector<Eigen::Vector3f> ends;
  ends.reserve(filtered.rays.size());
  for (const std::uint32_t ray : filtered.rays) ends.push_back(filtered.points[ray]);
  if (!parameters.clear_no_returns) return ends;
  const auto range = static_cast<float>(kBeyondRange * parameters.max_range);
  for (const Eigen::Vector3f& direction : scan.no_returns) ends.emplace_back(range * direction);
  return ends;
}

}  // namespace

OctomapMapper::OctomapMapper(const MappingParameters& parameters, const OctomapParameters& octomap)
    : parameters_((throwIfFaulty(parameters), parameters)),
      map_(octomap.resolution > 0.0 ? octomap.resolution : equalVolumeVoxel(parameters.radius), octomap.prune) {}

ScanReport OctomapMapper::insertScan(const LidarScan& scan, const Pose& sensor) {
  const std::lock_guard lock(mutex_);
  Random random = randomOfScan(parameters_.seed, scans_++);
  const ScanParameters& parameters = parameters_.scan;
  ScanReport report;
  const FilteredScan filtered =
      timed(report.seconds.filter, [&] { return filterScan(scan, parameters_.radius, parameters, random); });
  timed(report.seconds.merge, [&] {
    return map_.insertScan(raysOf(filtered, scan, parameters), sensor,
                           parameters.clear_no_returns ? parameters.max_range : -1.0);
  });
  report.filter = filtered.report;
  report.surface_points = static_cast<std::uint32_t>(filtered.rays.size());
  return report;
}

void OctomapMapper::reset() {
  const std::lock_guard lock(mutex_);
  map_.tree().clear();
  scans_ = 0;
}

}  // namespace atom_map
