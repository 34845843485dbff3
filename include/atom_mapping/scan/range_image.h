#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

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

  // `points` in the sensor frame, none at its origin; resolutions in radians, those of the sensor.
  RangeImage(const std::vector<Eigen::Vector3f>& points, double horizontal_resolution, double vertical_resolution);

  int columns() const { return columns_; }
  float columnAngle() const { return 6.2831853F / static_cast<float>(columns_); }  // radians
  Pixel pixel(std::uint32_t point) const { return pixels_[point]; }

  // Index of the nearest return in a pixel, or -1. Any row may be asked for, and columns up to one turn beyond the image.
  std::int32_t at(int row, int column) const;

 private:
  int rows_ = 0;
  int columns_;
  std::vector<Pixel> pixels_;          // one a point
  std::vector<std::int32_t> nearest_;  // row by row
};

}  // namespace atom_map
