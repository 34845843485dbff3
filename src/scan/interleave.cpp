#include "atom_mapping/scan/interleave.h"

#include <algorithm>
#include <cmath>

#include "atom_mapping/base/angles.h"

namespace atom_map {

float touchingAngle(float radius, float distance) {
  // The law of cosines in halves: its cosine rounds to 1 where atoms are small and far.
  return 2.0F * std::asin(std::min(1.0F, radius / distance));
}

Interleaver::Interleaver(float radius, float lambda, float max_distance, Random& random)
    : lambda_(lambda),
      steps_per_metre_(0.5F * kStepsPerDiameter / radius),
      diameters_(static_cast<std::uint32_t>(max_distance / (2.0F * radius)) + 2),
      random_(random) {
  touching_angles_.reserve(kStepsPerDiameter * (diameters_ + 1));
  for (std::uint32_t fraction = 0; fraction < kStepsPerDiameter; ++fraction) {
    for (std::uint32_t diameters = diameters_; diameters-- > 0;) {
      const auto step = static_cast<float>(diameters * kStepsPerDiameter + fraction);
      touching_angles_.push_back(touchingAngle(radius, (step + 0.5F) / steps_per_metre_));
    }
    touching_angles_.push_back(static_cast<float>(kPi));
  }
}

// The second loop runs four at a time, as that of findChances does: a compiler sees to it.
void Interleaver::findProbabilities(const std::vector<float>& distances, const std::vector<float>& rays_per_radian) {
  const std::size_t count = distances.size();
  probabilities_.resize(std::max(probabilities_.size(), count));
  for (std::size_t i = 0; i < count; ++i) probabilities_[i] = *touchingAngles(distances[i]);
  float* const probabilities = probabilities_.data();
  const float lambda = lambda_;
  for (std::size_t i = 0; i < count; ++i) {
    probabilities[i] = keepProbability(overlapCount(probabilities[i], rays_per_radian[i]), lambda);
  }
}

void Interleaver::findChances(float distance, std::uint32_t count, float rays_per_radian) {
  const float* const touching_angles = touchingAngles(distance);
  assert(touching_angles + count <= touching_angles_.data() + touching_angles_.size());
  chances_.resize(std::max<std::size_t>(chances_.size(), count));
  std::int32_t* const chances = chances_.data();
  const float lambda = lambda_;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float k = overlapCount(touching_angles[i], rays_per_radian);
    chances[i] = static_cast<std::int32_t>(keepProbability(k, lambda) * static_cast<float>(kOne));
  }
}

}  // namespace atom_map
