#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>

#include "atom_mapping/base/lanes.h"

namespace atom_map {

// Four boxes, which are compared with a point at once. At first all are empty: beyond every distance.
class FourBoxes {
 public:
  FourBoxes() {
    min_.fill(Floats{} + std::numeric_limits<float>::infinity());
    max_.fill(Floats{} - std::numeric_limits<float>::infinity());
  }

  // `min` and `max` hold x, y and z first; what follows means nothing.
  void set(std::uint32_t lane, const Floats& min, const Floats& max) {
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      min_[axis][lane] = min[axis];
      max_[axis][lane] = max[axis];
    }
  }

  // Which of the boxes, made wider by the radius on every side, hold the point within.
  Bits meet(const Eigen::Vector3f& p, float radius) const {
    const auto along = [&](std::uint32_t i) { return (min_[i] - p[i] < radius) & (p[i] - max_[i] < radius); };
    return along(0) & along(1) & along(2);
  }

  // From the point to the boxes.
  Floats squaredDistances(const Eigen::Vector3f& p) const {
    const auto along = [&](std::uint32_t i) {
      const Floats below = min_[i] - p[i];
      const Floats above = p[i] - max_[i];
      Floats gap = below > above ? below : above;
      gap = gap > 0.0F ? gap : Floats{};
      return gap * gap;
    };
    return along(0) + along(1) + along(2);
  }

 private:
  std::array<Floats, 3> min_;  // of each axis
  std::array<Floats, 3> max_;
};

}  // namespace atom_map
