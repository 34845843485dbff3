#include "atom_mapping/scan/range_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "atom_mapping/base/angles.h"
#include "atom_mapping/base/fast_atan2.h"
#include "atom_mapping/base/floor_to_int.h"

namespace atom_map {
namespace {

// The rows' offset, as a fraction of their height, for which the fewest points lie near the border of two rows: so that
// one ring never falls into two rows by the sensor's small errors of elevation.
float rowPhase(const std::vector<float>& elevations, float rows_per_radian) {
  constexpr int kBins = 16;
  std::array<int, kBins> counts{};
  for (const float elevation : elevations) {
    const float row = elevation * rows_per_radian;
    ++counts[std::min(kBins - 1, static_cast<int>((row - static_cast<float>(floorToInt(row))) * kBins))];
  }
  int best = 0;
  int fewest = static_cast<int>(4 * elevations.size()) + 1;
  for (int bin = 0; bin < kBins; ++bin) {
    const int beside = counts[(bin + kBins - 1) % kBins] + counts[(bin + 1) % kBins];
    if (2 * counts[bin] + beside >= fewest) continue;
    fewest = 2 * counts[bin] + beside;
    best = bin;
  }
  return (static_cast<float>(best) + 0.5F) / kBins;
}

}  // namespace

RangeImage::RangeImage(const std::vector<Eigen::Vector3f>& points, double horizontal_resolution,
                       double vertical_resolution)
    : columns_(std::max(1, static_cast<int>(std::lround(2.0 * kPi / horizontal_resolution)))) {
  if (points.empty()) return;
  std::vector<float> elevations(points.size());
  std::vector<float> azimuths(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f& p = points[i];
    elevations[i] = fastAtan2(p.z(), std::sqrt(p.x() * p.x() + p.y() * p.y()));
    azimuths[i] = fastAtan2(p.y(), p.x());
  }
  placeAll(elevations, azimuths, static_cast<float>(1.0 / vertical_resolution));
  keepNearest(points);
}

// The pixels of all points, and how many rows they take.
void RangeImage::placeAll(const std::vector<float>& elevations, const std::vector<float>& azimuths,
                          float rows_per_radian) {
  const float phase = rowPhase(elevations, rows_per_radian);
  const auto columns_per_radian = static_cast<float>(columns_ / (2.0 * kPi));
  pixels_.resize(elevations.size());
  first_row_ = std::numeric_limits<int>::max();
  end_row_ = std::numeric_limits<int>::min();
  for (std::size_t i = 0; i < elevations.size(); ++i) {
    const int row = floorToInt(elevations[i] * rows_per_radian - phase);
    const auto column = static_cast<int>((azimuths[i] + static_cast<float>(kPi)) * columns_per_radian);
    pixels_[i] = {row, column < columns_ ? column : 0};
    first_row_ = std::min(first_row_, row);
    end_row_ = std::max(end_row_, row + 1);
  }
}

void RangeImage::keepNearest(const std::vector<Eigen::Vector3f>& points) {
  nearest_.resize(static_cast<std::size_t>(end_row_ - first_row_) * columns_);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Return& nearest = nearest_[place(pixels_[i])];
    if (nearest.index >= 0 && points[i].squaredNorm() >= nearest.point.squaredNorm()) continue;
    nearest = {points[i], static_cast<std::int32_t>(i)};
  }
}

}  // namespace atom_map
