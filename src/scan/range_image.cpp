#include "atom_mapping/scan/range_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "atom_mapping/base/angles.h"

namespace atom_map {
namespace {

// The rows' offset, as a fraction of their height, for which the fewest points lie near the border of two rows: so that
// one ring never falls into two rows by the sensor's small errors of elevation.
float rowPhase(const std::vector<float>& elevations, float rows_per_radian) {
  constexpr int kBins = 16;
  std::array<int, kBins> counts{};
  for (const float elevation : elevations) {
    const float row = elevation * rows_per_radian;
    ++counts[std::min(kBins - 1, static_cast<int>((row - std::floor(row)) * kBins))];
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
  std::vector<float> elevations;
  elevations.reserve(points.size());
  for (const Eigen::Vector3f& p : points) elevations.push_back(std::atan2(p.z(), p.head<2>().norm()));

  const auto rows_per_radian = static_cast<float>(1.0 / vertical_resolution);
  const float phase = rowPhase(elevations, rows_per_radian);
  const auto columns_per_radian = static_cast<float>(columns_ / (2.0 * kPi));
  pixels_.reserve(points.size());
  first_row_ = std::numeric_limits<int>::max();
  end_row_ = std::numeric_limits<int>::min();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float azimuth = std::atan2(points[i].y(), points[i].x()) + static_cast<float>(kPi);
    const int row = static_cast<int>(std::floor(elevations[i] * rows_per_radian - phase));
    pixels_.push_back({row, static_cast<int>(azimuth * columns_per_radian) % columns_});
    first_row_ = std::min(first_row_, row);
    end_row_ = std::max(end_row_, row + 1);
  }
  if (points.empty()) return;
  nearest_.resize(static_cast<std::size_t>(end_row_ - first_row_) * columns_);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Return& nearest = nearest_[place(pixels_[i])];
    if (nearest.index >= 0 && points[i].squaredNorm() >= nearest.point.squaredNorm()) continue;
    nearest = {points[i], static_cast<std::int32_t>(i)};
  }
}

}  // namespace atom_map
