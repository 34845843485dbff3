// Stochastic angular interleaving (paper III-D): rays crowd near the sensor, so only some candidates stay, at random,
// such that about one of those that overlap one another does.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <vector>

#include "atom_mapping/base/random.h"

namespace atom_map {

// Angle at the sensor between two atoms of a radius, touching one another at a distance from it; pi where the sensor
// lies within them. Radians.
float touchingAngle(float radius, float distance);

// Number of candidates that overlap one, itself included, of rays that lie so close: Eq. (1).
inline float overlapCount(float touching_angle, float rays_per_radian) {
  const float rays = touching_angle * rays_per_radian;
  const auto below = static_cast<std::int32_t>(rays);
  const std::int32_t half = below + (static_cast<float>(below) < rays ? 1 : 0);
  return static_cast<float>(2 * half + 1);  // Eq. (1)
}

// Probability with which each of k overlapping candidates stays: Eq. (2).
inline float keepProbability(float k, float lambda) {
  return (1.0F + lambda) / (k + lambda);  // Eq. (2)
}

// Draws for the candidates of one scan.
class Interleaver {
 public:
  // Candidates may be asked for up to max_distance (m) from the sensor.
  Interleaver(float radius, float lambda, float max_distance, Random& random);

  // Whether the candidate at a distance from the sensor stays, among rays that lie angular_resolution (radians) apart.
  bool keep(float distance, float angular_resolution) {
    return random_.uniform() < probability(distance, 1.0F / angular_resolution);
  }

  // Calls visit(i) for those that stay of the candidates i = 0 to count - 1 of one ray, the first at `distance` from the
  // sensor and the others a diameter each nearer to it, with the same chance as in keep(). Without candidates,
  // `distance` may be anything.
  // Choice: the draws of one ray, whose candidates do not overlap, depend on one another: one stays each time that their
  // chances have added up to one more (systematic sampling). So it takes one number a ray, and long gaps are rarer.
  template <class Visit>
  void keepAlong(float distance, std::uint32_t count, float angular_resolution, Visit&& visit) {
    const float rays_per_radian = 1.0F / angular_resolution;
    const float lambda = lambda_;
    const float* const touching_angles = touching_angles_.data();
    auto step = static_cast<std::int32_t>(distance * steps_per_metre_);
    assert(count == 0 || static_cast<std::size_t>(step) < touching_angles_.size());
    // Without branches: which candidates stay is hard to foretell.
    kept_.resize(std::max<std::size_t>(kept_.size(), count + 1));
    std::uint32_t* end = kept_.data();
    float sum = random_.uniform();
    for (std::uint32_t i = 0; i < count; ++i) {
      sum += keepProbability(overlapCount(touching_angles[step], rays_per_radian), lambda);
      step = std::max(step - kStepsPerDiameter, 0);
      const bool stays = sum >= 1.0F;
      *end = i;
      end += stays ? 1 : 0;
      sum -= stays ? 1.0F : 0.0F;
    }
    std::for_each(kept_.data(), end, visit);
  }

 private:
  static constexpr std::int32_t kStepsPerDiameter = 16;

  float probability(float distance, float rays_per_radian) const {
    const auto step = static_cast<std::int32_t>(distance * steps_per_metre_);
    assert(step >= 0 && static_cast<std::size_t>(step) < touching_angles_.size());
    return keepProbability(overlapCount(touching_angles_[step], rays_per_radian), lambda_);
  }

  float lambda_;
  float steps_per_metre_;
  std::vector<float> touching_angles_;  // over distance
  std::vector<std::uint32_t> kept_;     // of the ray at hand
  Random& random_;
};

}  // namespace atom_map
