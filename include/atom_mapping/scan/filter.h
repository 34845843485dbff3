// Stage 1: which returns of a scan are used.
#pragma once

#include <cstdint>
#include <vector>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/base/random.h"
#include "atom_mapping/base/types.h"

namespace atom_map {

struct FilterReport {
  std::uint32_t points_in = 0;
  std::uint32_t nan = 0;        // a coordinate is not a number
  std::uint32_t no_return = 0;  // +Inf (REP 117): nothing within the sensor's range
  std::uint32_t too_near = 0;   // nearer than min_range, or -Inf (REP 117)
  std::uint32_t too_far = 0;    // beyond max_range
  std::uint32_t thinned = 0;    // another return of the same cell was kept
};

struct FilteredScan {
  std::vector<Eigen::Vector3f> points;  // valid returns, those beyond max_range too; sensor frame
  std::vector<std::uint32_t> rays;      // those to be traced, as indices into points, ascending
  FilterReport report;
};

// Drops invalid returns and traces none out of range (paper V-B); of the others one of each cubic cell of scan/thinning radii.
// Choice: which one is drawn, so that a robot at rest does not trace the same rays over and over.
FilteredScan filterScan(const LidarScan& scan, double radius, const ScanParameters& parameters, Random& random);

}  // namespace atom_map
