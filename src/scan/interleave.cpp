#include "atom_mapping/scan/interleave.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace atom_map {
namespace {

constexpr float kStepsPerRadius = 8.0F;

}  // namespace

float touchingAngle(float radius, float distance) {
  const float ratio = radius / distance;
  return std::acos(std::max(-1.0F, 1.0F - 2.0F * ratio * ratio));
}

float overlapCount(float touching_angle, float angular_resolution) {
  return 2.0F * std::ceil(touching_angle / angular_resolution) + 1.0F;  // Eq. (1)
}

float keepProbability(float k, float lambda) {
  return (1.0F + lambda) / (k + lambda);  // Eq. (2)
}

Interleaver::Interleaver(float radius, float lambda, float max_distance, Random& random)
    : lambda_(lambda), steps_per_metre_(kStepsPerRadius / radius), random_(random) {
  const auto steps = static_cast<std::size_t>(max_distance * steps_per_metre_) + 2;
  touching_angles_.reserve(steps);
  for (std::size_t i = 0; i < steps; ++i) {
    touching_angles_.push_back(touchingAngle(radius, (static_cast<float>(i) + 0.5F) / steps_per_metre_));
  }
}

bool Interleaver::keep(float distance, float angular_resolution) {
  const auto step = static_cast<std::size_t>(distance * steps_per_metre_);
  assert(step < touching_angles_.size());
  const float k = overlapCount(touching_angles_[step], angular_resolution);
  return random_.uniform() < keepProbability(k, lambda_);
}

}  // namespace atom_map
