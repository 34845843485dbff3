#include "atom_mapping/scan/filter.h"

#include <algorithm>
#include <limits>
#include <utility>

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

// One point of each cell, every one with the same probability (reservoir sampling).
void thin(FilteredScan& scan, float cell_size, Random& random) {
  struct Cell {
    std::uint32_t points = 0;
    std::uint32_t place = 0;  // in kept
  };
  CellTable<Cell> cells(cell_size);
  std::vector<std::uint32_t> kept;
  for (const std::uint32_t ray : scan.rays) {
    Cell& cell = cells.at(scan.points[ray]);
    if (cell.points++ == 0) {
      cell.place = static_cast<std::uint32_t>(kept.size());
      kept.push_back(ray);
    } else if (random.uniform() * static_cast<float>(cell.points) < 1.0F) {
      kept[cell.place] = ray;
    }
  }
  std::sort(kept.begin(), kept.end());
  scan.report.thinned = static_cast<std::uint32_t>(scan.rays.size() - kept.size());
  scan.rays = std::move(kept);
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
