#pragma once

#include <Eigen/Core>
#include <cassert>
#include <cstdint>
#include <vector>

#include "atom_mapping/scan/directions.h"

namespace atom_map {

// The returns of a scan by the direction from which they came: rows of elevation, columns of azimuth that close a
// circle. Finds the neighbours of a return on its own ring and on the rings beside it, however far apart these lie in
// space, for organized and unorganized clouds alike.
class RangeImage {
 public:
  struct Pixel {
    int row;
    int column;
  };
  // The nearest return in a pixel.
  struct Return {
    float range = 0.0F;       // m
    std::int32_t index = -1;  // of the point; -1 where the pixel is empty
  };

  // `points` in the sensor frame, finite and none at its origin; resolutions in radians, those of the sensor.
  RangeImage(const std::vector<Eigen::Vector3f>& points, double horizontal_resolution, double vertical_resolution);

  int columns() const { return columns_; }
  float columnAngle() const { return 6.2831853F / static_cast<float>(columns_); }  // radians
  Pixel pixel(std::uint32_t point) const { return pixels_[point]; }

  // Of a row its columns() pixels; nullptr where it holds no return.
  const Return* row(int row) const {
    if (row < first_row_ || row >= end_row_) return nullptr;
    return nearest_.data() + static_cast<std::size_t>(row - first_row_) * columns_;
  }

  // Where a column up to one turn beyond the image lies in it.
  int wrapped(int column) const {
    if (column < 0) column += columns_;
    if (column >= columns_) column -= columns_;
    assert(column >= 0 && column < columns_);
    return column;
  }

  // Any row may be asked for, and columns up to one turn beyond the image.
  Return at(int row, int column) const {
    const Return* const pixels = this->row(row);
    return pixels == nullptr ? Return() : pixels[wrapped(column)];
  }

 private:
  void placeAll(const Directions& directions, float rows_per_radian);
  void keepNearest(const std::vector<float>& ranges);

  std::size_t place(const Pixel& pixel) const {
    return static_cast<std::size_t>(pixel.row - first_row_) * columns_ + pixel.column;
  }

  int first_row_ = 0;  // of those that hold returns
  int end_row_ = 0;
  int columns_;
  std::vector<Pixel> pixels_;    // one a point
  std::vector<Return> nearest_;  // row by row
};

}  // namespace atom_map
