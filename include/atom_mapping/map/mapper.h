// The mapping itself: the paper's Algorithm 1, over a map that others may read meanwhile.
#pragma once

#include <cstdint>
#include <mutex>
#include <shared_mutex>
#include <utility>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/base/types.h"
#include "atom_mapping/map/atom_map.h"
#include "atom_mapping/map/forget.h"
#include "atom_mapping/map/scan_report.h"
#include "atom_mapping/scan/rays.h"

namespace atom_map {

// Thread safety: any member may be called at any time from any thread. Scans must come from one thread at a time, in
// their order: same scans, poses and parameters give the same map, whoever reads it meanwhile.
class Mapper {
 public:
  // Throws std::invalid_argument that names every parameter out of its range.
  explicit Mapper(const MappingParameters& parameters);

  // Merges one scan into the map (Algorithm 1). Returns that cannot be used are counted in the report. The limits hold
  // afterwards; by what policy, the report tells. Throws std::bad_alloc alone, after which the map is good for reset() only.
  // `sensor`: sensor frame to map frame at the scan's stamp; must be finite.
  ScanReport insertScan(const LidarScan& scan, const Pose& sensor);

  // Calls f(const AtomMap&) and returns what it returns. The map stands still meanwhile, so f should be short:
  // milliseconds; a long reading is better cut into several.
  template <class F>
  auto read(F&& f) const {
    const auto lock = lockToRead();
    return std::forward<F>(f)(map_);
  }

  // Calls f(AtomMap&), alone. f may change and remove atoms, but must not reset or anchor the map: a scan that is being
  // merged would be misplaced.
  template <class F>
  auto write(F&& f) {
    std::unique_lock door(door_);
    const std::unique_lock lock(mutex_);
    door.unlock();
    return std::forward<F>(f)(map_);
  }

  // Calls f(const AtomMap&, number of scans merged) as read does, but between two scans.
  template <class F>
  auto readBetweenScans(F&& f) const {
    const std::lock_guard scan_lock(scan_mutex_);
    const auto lock = lockToRead();
    return std::forward<F>(f)(map_, scans_);
  }

  // Takes another map, of this one's mode and radius, and goes on as if it had been made here of so many scans; waits for
  // a scan that is being merged. A map beyond the limits is the caller's to fit (forgetFarthest) or to refuse; log-odds
  // beyond occupancy/max_log_odds are clamped to it.
  void replace(AtomMap map, std::uint64_t scans);

  // The same with a map of any mode and of `radius` (m): where this one holds no atoms, it takes over both. Returns false,
  // and changes nothing, where it holds some and is of another mode or radius.
  bool adopt(AtomMap map, double radius, std::uint64_t scans);

  // Empties the map and starts the random draws anew; waits for a scan that is being merged.
  void reset();

  // May be asked within read() and its like, where they are those of the map.
  MappingParameters parameters() const {
    const std::lock_guard lock(parameters_mutex_);
    return parameters_;
  }

 private:
  // Behind a writer that waits.
  std::shared_lock<std::shared_mutex> lockToRead() const {
    const std::lock_guard door(door_);
    return std::shared_lock(mutex_);
  }

  void mergeOccupancy(const std::vector<SurfacePoint>& surface, const std::vector<Eigen::Vector3f>& no_returns,
                      const Eigen::Isometry3f& sensor, Random& random, ScanReport& report);
  void mergeDistances(const std::vector<SurfacePoint>& surface, const Eigen::Vector3f& sensor, Random& random,
                      ScanReport& report);
  template <class AnyCandidates>
  AnyCandidates gridFiltered(AnyCandidates interleaved, ScanReport& report) const;
  template <class AnyCandidate, class Merging>
  void merge(const std::vector<AnyCandidate>& candidates, Merging& merging, ScanReport& report);
  MapLimit refusedBeyond() const;
  std::size_t forget(const Eigen::Vector3d& sensor);
  std::size_t forgetBeyond(const KeptBall& kept);

  MappingParameters parameters_;  // written by who holds all three
  MapLimit limit_;
  mutable std::mutex parameters_mutex_;  // held last
  mutable std::mutex scan_mutex_;        // held from a scan's first stage to its last
  mutable std::mutex door_;              // to mutex_, held by a writer that waits: readers alone would never let it in
  mutable std::shared_mutex mutex_;      // of the map
  AtomMap map_;
  std::uint64_t scans_ = 0;
};

}  // namespace atom_map
