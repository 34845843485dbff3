#include "atom_mapping/scan/filter.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "atom_mapping/base/cell_table.h"

namespace atom_map {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kNearest = 1e-3;  // m, at the sensor itself: some drivers' mark of no return
constexpr double kFarthest = 1e4;  // m, beyond any lidar: no more than noise

// A return beyond max_range is not traced, but tells of the surface that nearer ones lie on.
void sortOut(const Eigen::Vector3f& point, double min_range, double max_range, FilteredScan& filtered) {
  FilterReport& report = filtered.report;
  const double range = point.cast<double>().norm();  // the square of a float may overflow
  if (point.hasNaN()) {
    ++report.nan;
  } else if (point.maxCoeff() == kInfinity) {
    ++report.no_return;
  } else if (point.minCoeff() == -kInfinity || range < min_range) {
    ++report.too_near;
  } else if (range > max_range) {
    ++report.too_far;
    if (range <= kFarthest) filtered.points.push_back(point);
  } else {
    filtered.rays.push_back(static_cast<std::uint32_t>(filtered.points.size()));
    filtered.points.push_back(point);
  }
}

// Sorts the returns into those that serve and those that are only counted.
void sortReturns(const LidarScan& scan, const ScanParameters& parameters, FilteredScan& filtered) {
  const double min_range = std::max(parameters.min_range, kNearest);
  // Within these squares, narrowed by the rounding of a float, a return is in range beyond doubt, as most are.
  const auto least = static_cast<float>(min_range * min_range * (1.0 + 1e-6));
  const auto greatest = static_cast<float>(parameters.max_range * parameters.max_range * (1.0 - 1e-6));
  filtered.points.reserve(scan.points.size());
  filtered.rays.reserve(scan.points.size());
  for (const Eigen::Vector3f& point : scan.points) {
    const float squared = point.squaredNorm();
    if (squared > least && squared < greatest) {
      filtered.rays.push_back(static_cast<std::uint32_t>(filtered.points.size()));
      filtered.points.push_back(point);
    } else {
      sortOut(point, min_range, parameters.max_range, filtered);
    }
  }
}

// One point of each cell, every one with the same probability: that with the greatest number drawn.
// Choice: cells of half a radius. With a whole one a scan takes a fifth less time and long drives give as good a map, but in a
// room, seen by few scans, free space is found more slowly. With one far off only, where rings lie apart, less of a busy street's
// surfaces is kept.
void thin(FilteredScan& scan, float cell_size, Random& random) {
  constexpr std::uint64_t kNumber = ~std::uint64_t{0} << 32;  // beneath it, which of the rays it is
  constexpr std::size_t kPointsPerCell = 4;                   // about
  const auto count = static_cast<std::uint32_t>(scan.rays.size());
  CellTable<std::uint64_t> cells(cell_size, count / kPointsPerCell);
  std::uint64_t draw = 0;  // for two rays
  cells.atEach(
      count, [&](std::size_t i) { return scan.points[scan.rays[i]]; },
      [&](std::size_t i, std::uint64_t& greatest) {
        draw = i % 2 == 0 ? random.next() : draw << 32U;
        greatest = std::max(greatest, (draw & kNumber) | i);
      });
  std::vector<std::uint8_t> is_kept(count, 0);
  cells.forEach([&](std::uint64_t greatest) { is_kept[greatest & ~kNumber] = 1; });
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    scan.rays[kept] = scan.rays[i];
    kept += is_kept[i];
  }
  scan.rays.resize(kept);
  scan.report.thinned = count - kept;
}

}  // namespace

FilteredScan filterScan(const LidarScan& scan, double radius, const ScanParameters& parameters, Random& random) {
  FilteredScan filtered;
  filtered.report.points_in = static_cast<std::uint32_t>(scan.points.size());
  sortReturns(scan, parameters, filtered);
  if (parameters.thinning > 0.0) thin(filtered, static_cast<float>(parameters.thinning * radius), random);
  return filtered;
}

}  // namespace atom_map
