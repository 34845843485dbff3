#pragma once

#include <algorithm>

namespace atom_map {

// Fraction of a sphere that lies within another of the same radius, as a function of the distance between their centres
// over their diameter: 1 where they coincide, 0 from touching on.
inline float overlapFraction(float distance_over_diameter) {
  const float t = std::min(distance_over_diameter, 1.0F);
  return (1.0F - t) * (1.0F - t) * (1.0F + 0.5F * t);  // Eq. (4), with d = 2 r t; factored: exact where it vanishes
}

}  // namespace atom_map
