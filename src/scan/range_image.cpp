#include "atom_mapping/scan/range_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "atom_mapping/base/angles.h"
#include "atom_mapping/base/floor_to_int.h"
#include "atom_mapping/scan/directions.h"

namespace atom_map {
namespace {

// The rows' offset, as a fraction of their height, for which the fewest points lie near the border of two rows: so that
// one ring never falls into two rows by the sensor's small errors of elevation.
float rowPhase(const std::vector<float>& elevations, float rows_per_radian) {
  constexpr int kBins = 16;
  std::array<int, kBins> counts{};
  for (const float elevation : elevations) ++counts[floorToInt(elevation * rows_per_radian * kBins) & (kBins - 1)];
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
  const Directions directions = directionsOf(points);
  placeAll(directions, static_cast<float>(1.0 / vertical_resolution));
  keepNearest(directions.range);
}

// The pixels of all points, and how many rows they take. A compiler makes its loops run four at a time.
void RangeImage::placeAll(const Directions& directions, float rows_per_radian) {
  const std::size_t count = directions.elevation.size();
  const int columns = columns_;
  const auto columns_per_radian = static_cast<float>(columns / (2.0 * kPi));
  const float phase = rowPhase(directions.elevation, rows_per_radian);
  pixels_.resize(count);
  Pixel* const pixels = pixels_.data();
  for (std::size_t i = 0; i < count; ++i) {
    const auto column = static_cast<int>((directions.azimuth[i] + static_cast<float>(kPi)) * columns_per_radian);
    pixels[i].row = floorToInt(directions.elevation[i] * rows_per_radian - phase);
    pixels[i].column = column < columns ? column : 0;
  }
  int first = pixels[0].row;
  int last = first;
  for (std::size_t i = 1; i < count; ++i) {
    first = std::min(first, pixels[i].row);
    last = std::max(last, pixels[i].row);
  }
  first_row_ = first;
  end_row_ = last + 1;
}

void RangeImage::keepNearest(const std::vector<float>& ranges) {
  nearest_.resize(static_cast<std::size_t>(end_row_ - first_row_) * columns_);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    Return& nearest = nearest_[place(pixels_[i])];
    if (nearest.index < 0 || ranges[i] < nearest.range) nearest = {ranges[i], static_cast<std::int32_t>(i)};
  }
}

}  // namespace atom_map
