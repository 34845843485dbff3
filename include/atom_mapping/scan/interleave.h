// Stochastic angular interleaving (paper III-D): rays crowd near the sensor, so only some candidates stay, at random,
// such that about one of those that overlap one another does.
#pragma once

#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

#include "atom_mapping/base/random.h"

namespace atom_map {

// Angle at the sensor between two atoms of a radius, touching one another at a distance from it; pi where the sensor
// lies within them. Radians.
float touchingAngle(float radius, float distance);

// Number of candidates that overlap one, itself included, of rays that lie an angle (radians) apart: Eq. (1).
inline float overlapCount(float touching_angle, float angular_resolution) {
  const auto below = static_cast<std::int32_t>(touching_angle / angular_resolution);
  const std::int32_t half = below + (static_cast<float>(below) * angular_resolution < touching_angle ? 1 : 0);
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
    return random_.uniform() < probability(distance, angular_resolution);
  }

  // Calls visit(i) for those that stay of the candidates i = 0 to count - 1 of one ray, at distance - i * step from the sensor, with
  // the same chances as keep(). None has a better chance than the first, so its misses in a row are drawn at once.
  template <class Visit>
  void keepAlong(float distance, float step, std::uint32_t count, float angular_resolution, Visit&& visit) {
    const float greatest = probability(distance, angular_resolution);
    const float per_miss = 1.0F / std::log1p(-greatest);  // -0 where none misses
    for (std::uint32_t i = 0; i < count; ++i) {
      const float misses = std::log(1.0F - random_.uniform()) * per_miss;
      if (misses >= static_cast<float>(count - i)) return;
      i += static_cast<std::uint32_t>(misses);
      const float chance = probability(distance - static_cast<float>(i) * step, angular_resolution);
      if (random_.uniform() * greatest < chance) visit(i);
    }
  }

 private:
  float probability(float distance, float angular_resolution) const {
    const auto step = static_cast<std::size_t>(distance * steps_per_metre_);
    assert(step < touching_angles_.size());
    return keepProbability(overlapCount(touching_angles_[step], angular_resolution), lambda_);
  }

  float lambda_;
  float steps_per_metre_;
  std::vector<float> touching_angles_;  // over distance
  Random& random_;
};

}  // namespace atom_map
