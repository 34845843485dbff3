#include "atom_mapping/scan/interleave.h"

#include <algorithm>
#include <cmath>

namespace atom_map {

float touchingAngle(float radius, float distance) {
  const float ratio = radius / distance;
  return std::acos(std::max(-1.0F, 1.0F - 2.0F * ratio * ratio));
}

Interleaver::Interleaver(float radius, float lambda, float max_distance, Random& random)
    : lambda_(lambda), steps_per_metre_(0.5F * kStepsPerDiameter / radius), random_(random) {
  const auto steps = static_cast<std::size_t>(max_distance * steps_per_metre_) + 2;
  touching_angles_.reserve(steps);
  for (std::size_t i = 0; i < steps; ++i) {
    touching_angles_.push_back(touchingAngle(radius, (static_cast<float>(i) + 0.5F) / steps_per_metre_));
  }
}

}  // namespace atom_map
