#pragma once

#include <algorithm>
#include <cmath>

#include "atom_mapping/base/angles.h"

namespace atom_map {

// std::atan2 with an error of at most 4e-6, without branches, so that a compiler makes a loop over many of it run four at a time. Both
// arguments finite; 0 where both are.
inline float fastAtan2(float y, float x) {
  const float high = std::max(std::abs(x), std::abs(y));
  const float low = std::min(std::abs(x), std::abs(y));
  const float t = low / std::max(high, 1e-30F);
  const float s = t * t;
  // Minimax polynomial of atan on [0, 1] (after Hastings).
  const float octant =
      t * (0.99997726F +
           s * (-0.33262347F + s * (0.19354346F + s * (-0.11643287F + s * (0.05265332F + s * -0.01172120F)))));
  constexpr auto kHalfPi = static_cast<float>(0.5 * kPi);
  const float quadrant = std::abs(y) > std::abs(x) ? kHalfPi - octant : octant;
  const float half = x < 0.0F ? 2.0F * kHalfPi - quadrant : quadrant;
  return std::copysign(half, y);
}

}  // namespace atom_map
