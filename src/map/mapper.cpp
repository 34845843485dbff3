#include "atom_mapping/map/mapper.h"

#include <algorithm>
#include <chrono>

#include "atom_mapping/base/check_parameters.h"
#include "atom_mapping/scan/candidate_filter.h"
#include "atom_mapping/scan/rays.h"

namespace atom_map {
namespace {

// Merged under one lock: some 0.1 ms, which is what a reader waits for.
constexpr std::ptrdiff_t kMergeSlice = 512;

// Calls stage() and adds the time that it took.
template <class Stage>
auto timed(double& seconds, Stage&& stage) {
  const auto start = std::chrono::steady_clock::now();
  auto result = stage();
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::vector<SurfacePoint> transformed(std::vector<SurfacePoint> surface, const Eigen::Isometry3f& pose) {
  for (SurfacePoint& point : surface) {
    point.position = pose * point.position;
    point.normal = pose.linear() * point.normal;
  }
  return surface;
}

std::vector<Eigen::Vector3f> rotated(std::vector<Eigen::Vector3f> directions, const Eigen::Matrix3f& rotation) {
  for (Eigen::Vector3f& direction : directions) direction = rotation * direction;
  return directions;
}

}  // namespace

Mapper::Mapper(const MappingParameters& parameters)
    : parameters_((throwIfFaulty(parameters), parameters)), map_(parameters.mode, parameters.radius) {}

// Algorithm 1, lines 5 to 11.
ScanReport Mapper::insertScan(const LidarScan& scan, const Pose& sensor) {
  const std::lock_guard scan_lock(scan_mutex_);
  Random random(mixBits(parameters_.seed) + scans_++);
  Eigen::Isometry3f pose(sensor.linear().cast<float>());  // sensor frame to the map's local frame
  pose.translation() = write([&](AtomMap& map) {
    map.anchor(sensor.translation());
    return map.toLocal(sensor.translation());
  });
  ScanReport report;

  const FilteredScan filtered =
      timed(report.seconds.filter, [&] { return filterScan(scan, parameters_.radius, parameters_.scan, random); });
  const std::vector<SurfacePoint> surface = timed(report.seconds.normals, [&] {
    return transformed(estimateSurface(filtered, parameters_.scan, report.normals), pose);
  });
  const Candidates interleaved = timed(report.seconds.rays, [&] {
    const auto no_returns =
        rotated(parameters_.scan.clear_no_returns ? scan.no_returns : decltype(scan.no_returns){}, pose.linear());
    return traceRays(surface, no_returns, pose.translation(), parameters_, random);
  });
  const Candidates candidates = timed(report.seconds.candidate_filter, [&] {
    const double cell = parameters_.rays.candidate_cell * 2.0 * parameters_.radius;
    return cell > 0.0 ? filterCandidates(interleaved, static_cast<float>(cell)) : interleaved;
  });
  report.merge = timed(report.seconds.merge, [&] { return merge(candidates); });

  report.filter = filtered.report;
  report.surface_points = static_cast<std::uint32_t>(surface.size());
  report.candidates_proposed = interleaved.proposed;
  report.candidates_interleaved = static_cast<std::uint32_t>(interleaved.size());
  report.candidates_kept = static_cast<std::uint32_t>(candidates.size());
  read([&](const AtomMap& map) {
    report.atoms = map.atoms().size();
    report.map_bytes = map.atoms().bytes();
  });
  return report;
}

// Slice by slice, so that readers wait for a slice only and not for the whole scan.
MergeReport Mapper::merge(const Candidates& candidates) {
  OccupancyMerge merging(map_, parameters_.occupancy);
  for (const auto* part : {&candidates.occupied, &candidates.free}) {
    const Candidate* const end = part->data() + part->size();
    for (const Candidate* slice = part->data(); slice != end;) {
      const Candidate* const slice_end = slice + std::min(kMergeSlice, end - slice);
      write([&](AtomMap&) { merging.add(slice, slice_end); });
      slice = slice_end;
    }
  }
  return merging.report();
}

void Mapper::reset() {
  const std::lock_guard scan_lock(scan_mutex_);
  write([](AtomMap& map) { map.reset(); });
  scans_ = 0;
}

}  // namespace atom_map
