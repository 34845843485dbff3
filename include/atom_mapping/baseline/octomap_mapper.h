// What Mapper is for the atom map: scans in, OctoMap out, the same returns used of each scan.
#pragma once

#include <cstdint>
#include <mutex>
#include <utility>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/baseline/octomap_baseline.h"
#include "atom_mapping/map/scan_report.h"

namespace atom_map {

// Thread safety: any member may be called at any time from any thread, one waits for the other.
class OctomapMapper {
 public:
  // Of `parameters` only radius, seed and scan matter. Throws std::invalid_argument that names every parameter out of
  // its range.
  OctomapMapper(const MappingParameters& parameters, const OctomapParameters& octomap);

  // Merges the returns that Mapper's filter lets through, the very same for the same seed. Of the report, `atoms` and
  // `map_bytes` stay 0, since OctoMap counts neither as it grows.
  ScanReport insertScan(const LidarScan& scan, const Pose& sensor);

  // Calls f(const OctomapBaseline&) and returns what it returns. Scans wait meanwhile.
  template <class F>
  auto read(F&& f) const {
    const std::lock_guard lock(mutex_);
    return std::forward<F>(f)(std::as_const(map_));
  }

  void reset();

  const MappingParameters& parameters() const { return parameters_; }

 private:
  MappingParameters parameters_;
  mutable std::mutex mutex_;  // of what follows
  OctomapBaseline map_;
  std::uint64_t scans_ = 0;
};

}  // namespace atom_map
