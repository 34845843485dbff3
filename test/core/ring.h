#pragma once

#include <cmath>

#include "atom_mapping/scan/interleave.h"

namespace atom_map {

constexpr float kRadius = 0.5F;
constexpr float kMaxDistance = 25.0F;
constexpr double kSigmas = 5.0;

// A 2D radial sensor: one candidate on each of its rays, at one distance.
struct Ring {
  int rays;
  float distance;
  float lambda;

  float resolution() const { return 6.2831853F / static_cast<float>(rays); }
  // Candidates that overlap one, itself included: counted, not by Eq. (1).
  int overlapping() const {
    int count = 0;
    for (int i = 0; i < rays; ++i) {
      const double chord = 2.0 * distance * std::sin(M_PI * i / rays);
      count += chord < 2.0 * static_cast<double>(kRadius) ? 1 : 0;
    }
    return count;
  }
  // Eq. (2) over Eq. (1), at a distance that is known to a sixteenth of a radius.
  double keepProbabilityAt(float error) const {
    const float k = overlapCount(touchingAngle(kRadius, distance + error * kRadius / 16.0F), 1.0F / resolution());
    return static_cast<double>(keepProbability(k, lambda));
  }
};

}  // namespace atom_map
