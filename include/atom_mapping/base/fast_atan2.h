#pragma once

#include <cmath>

#include "atom_mapping/base/angles.h"

namespace atom_map {

// std::atan2 with an error of at most 4e-6, without branches, so that a compiler makes a loop over many of it run four at a time. Both
// arguments finite; 0 where both are.
inline float fastAtan2(float y, float x) {
  const float width = std::abs(x);
  const float height = std::abs(y);
  const float high = width > height ? width : height;
  const float low = width > height ? height : width;
  const float t = low / (high + 1e-30F);
  const float s = t * t;
  // Minimax polynomial of atan on [0, 1] (after Hastings).
  const float octant =
      t * (0.99997726F +
           s * (-0.33262347F + s * (0.19354346F + s * (-0.11643287F + s * (0.05265332F + s * -0.01172120F)))));
  constexpr auto kHalfPi = static_cast<float>(0.5 * kPi);
  const float complement = kHalfPi - octant;
  const float quadrant = height > width ? complement : octant;
  const float supplement = 2.0F * kHalfPi - quadrant;
  const float half = x < 0.0F ? supplement : quadrant;
  return std::copysign(half, y);
}

}  // namespace atom_map
