#include "atom_mapping/map/mapper.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "atom_mapping/base/check_parameters.h"
#include "atom_mapping/base/timed.h"
#include "atom_mapping/scan/candidate_filter.h"
#include "atom_mapping/scan/drop_crossing.h"
#include "atom_mapping/scan/normals.h"
#include "atom_mapping/scan/rays.h"
#include "atom_mapping/scan/snap.h"

namespace atom_map {
namespace {

// Merged under one lock: some 0.1 ms, which is what a reader waits for.
constexpr std::ptrdiff_t kMergeSlice = 512;

// As if they had been mapped with this clamp.
void clampLogOdds(float most, AtomTree& atoms) {
  constexpr float kAll = std::numeric_limits<float>::max();
  LeafSearch search;
  atoms.forEachLeaf({Eigen::Vector3f::Constant(-kAll), Eigen::Vector3f::Constant(kAll)}, search,
                    [&](AtomBlock& leaf, const Floats&, const Floats&) {
                      for (std::uint32_t i = 0; i < leaf.size(); ++i) {
                        leaf.setValue(i, 0, std::clamp(leaf.channel(3)[i], -most, most));
                      }
                    });
}

std::vector<Eigen::Vector3f> rotated(std::vector<Eigen::Vector3f> directions, const Eigen::Matrix3f& rotation) {
  for (Eigen::Vector3f& direction : directions) direction = rotation * direction;
  return directions;
}

}  // namespace

Mapper::Mapper(const MappingParameters& parameters)
    : parameters_((throwIfFaulty(parameters), parameters)),
      limit_(limitOf(parameters.limits)),
      map_(parameters.mode, parameters.radius) {}

// Algorithm 1, lines 5 to 11.
ScanReport Mapper::insertScan(const LidarScan& scan, const Pose& sensor) {
  const std::lock_guard scan_lock(scan_mutex_);
  Random random = randomOfScan(parameters_.seed, scans_++);
  Eigen::Isometry3f pose(sensor.linear().cast<float>());  // sensor frame to the map's local frame
  std::vector<KnownPlane> planes;
  pose.translation() = write([&](AtomMap& map) {
    map.anchor(sensor.translation());
    planes = std::move(map.planes());
    return map.toLocal(sensor.translation());
  });
  ScanReport report;

  const FilteredScan filtered =  // line 5
      timed(report.seconds.filter, [&] { return filterScan(scan, parameters_.radius, parameters_.scan, random); });
  const std::vector<SurfacePoint> surface = timed(report.seconds.normals, [&] {  // line 6
    return estimateSurface(filtered, pose, parameters_.radius, parameters_.scan, planes, report.normals);
  });
  parameters_.mode == Mode::kOccupancy  // lines 7 to 11
      ? mergeOccupancy(surface, scan.no_returns, pose, random, report)
      : mergeDistances(surface, pose.translation(), random, report);
  report.forgotten = timed(report.seconds.forget, [&] { return forget(sensor.translation()); });

  report.filter = filtered.report;
  report.surface_points = static_cast<std::uint32_t>(surface.size());
  write([&](AtomMap& map) {
    map.planes() = std::move(planes);
    report.atoms = map.atoms().size();
    report.map_bytes = map.atoms().bytes();
  });
  return report;
}

// Lines 8 to 11, with steps A and B.
void Mapper::mergeOccupancy(const std::vector<SurfacePoint>& surface, const std::vector<Eigen::Vector3f>& no_returns,
                            const Eigen::Isometry3f& sensor, Random& random, ScanReport& report) {
  Candidates candidates = timed(report.seconds.rays, [&] {
    std::vector<Eigen::Vector3f> cleared;
    if (parameters_.scan.clear_no_returns) cleared = rotated(no_returns, sensor.linear());
    return traceRays(surface, cleared, sensor.translation(), parameters_, random);
  });
  candidates = gridFiltered(std::move(candidates), report);
  timed(report.seconds.candidate_filter, [&] {
    snapToLattice(candidates.occupied, map_.radius());
    snapToLattice(candidates.free, map_.radius());
    return 0;
  });
  OccupancyMerge merging(map_, parameters_.occupancy, refusedBeyond());
  merge(candidates.occupied, merging, report);
  merge(candidates.free, merging, report);
}

// Lines 8 to 11, with steps A and C.
void Mapper::mergeDistances(const std::vector<SurfacePoint>& surface, const Eigen::Vector3f& sensor, Random& random,
                            ScanReport& report) {
  DistanceCandidates candidates =
      timed(report.seconds.rays, [&] { return traceNormals(surface, sensor, parameters_, random); });
  candidates = gridFiltered(std::move(candidates), report);
  timed(report.seconds.candidate_filter, [&] {
    dropCrossing(surface, static_cast<float>(parameters_.scan.range_noise), candidates);
    snapToLattice(candidates.behind, map_.radius());
    snapToLattice(candidates.infront, map_.radius());
    return 0;
  });
  report.candidates_kept = static_cast<std::uint32_t>(candidates.size());
  DistanceMerge merging(map_, parameters_.signed_distance, refusedBeyond());
  merge(candidates.behind, merging, report);
  merge(candidates.infront, merging, report);
}

template <class AnyCandidates>
AnyCandidates Mapper::gridFiltered(AnyCandidates interleaved, ScanReport& report) const {
  report.candidates_proposed = interleaved.proposed;
  report.candidates_interleaved = static_cast<std::uint32_t>(interleaved.size());
  const double cell = parameters_.rays.candidate_cell * 2.0 * parameters_.radius;
  AnyCandidates kept = timed(report.seconds.candidate_filter, [&] {
    return cell > 0.0 ? filterCandidates(interleaved, static_cast<float>(cell)) : std::move(interleaved);
  });
  report.candidates_kept = static_cast<std::uint32_t>(kept.size());
  return kept;
}

// Slice by slice, so that readers wait for a slice only and not for the whole scan.
template <class AnyCandidate, class Merging>
void Mapper::merge(const std::vector<AnyCandidate>& candidates, Merging& merging, ScanReport& report) {
  report.merge = timed(report.seconds.merge, [&] {
    const AnyCandidate* const end = candidates.data() + candidates.size();
    for (const AnyCandidate* slice = candidates.data(); slice != end;) {
      const AnyCandidate* const slice_end = slice + std::min(kMergeSlice, end - slice);
      write([&](AtomMap&) { merging.add(slice, slice_end); });
      slice = slice_end;
    }
    return merging.report();
  });
}

void Mapper::replace(AtomMap map, std::uint64_t scans) {
  assert(map.mode() == map_.mode() && map.radius() == map_.radius());
  adopt(std::move(map), parameters().radius, scans);
}

bool Mapper::adopt(AtomMap map, double radius, std::uint64_t scans) {
  assert(map.radius() == static_cast<float>(radius));
  if (map.mode() == Mode::kOccupancy) {  // before scans have to wait
    clampLogOdds(static_cast<float>(parameters().occupancy.max_log_odds), map.atoms());
  }
  const std::lock_guard scan_lock(scan_mutex_);
  const bool adopted = write([&](AtomMap& mine) {
    const bool is_alike = map.mode() == parameters_.mode && radius == parameters_.radius;
    if (mine.atoms().size() > 0 && !is_alike) return false;
    std::swap(mine, map);  // the old one is freed when readers may read again
    const std::lock_guard lock(parameters_mutex_);
    parameters_.mode = mine.mode();
    parameters_.radius = radius;
    return true;
  });
  if (adopted) scans_ = scans;
  return adopted;
}

void Mapper::reset() {
  const std::lock_guard scan_lock(scan_mutex_);
  write([](AtomMap& map) { map.reset(); });
  scans_ = 0;
}

}  // namespace atom_map
