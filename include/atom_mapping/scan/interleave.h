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

  // Calls visit(i) for those that stay of candidates that do not depend on one another, each at its distance (m) from the
  // sensor among rays that lie so close: one number of each a candidate.
  template <class Visit>
  void keepEach(const std::vector<float>& distances, const std::vector<float>& rays_per_radian, Visit&& visit) {
    assert(distances.size() == rays_per_radian.size());
    findProbabilities(distances, rays_per_radian);
    kept_.resize(std::max(kept_.size(), distances.size() + 1));
    std::uint32_t* end = kept_.data();
    for (std::uint32_t i = 0; i < distances.size(); ++i) {
      *end = i;
      end += random_.uniform() < probabilities_[i] ? 1 : 0;
    }
    std::for_each(kept_.data(), end, visit);
  }

  // Calls visit(i) for those that stay of the candidates i = 0 to count - 1 of one ray, the first at `distance` from the
  // sensor and the others a diameter each nearer to it, with the same chance as in keepEach(). Without candidates,
  // `distance` may be anything.
  // Choice: the draws of one ray, whose candidates do not overlap, depend on one another: one stays each time that their
  // chances have added up to one more (systematic sampling). So it takes one number a ray, and long gaps are rarer.
  template <class Visit>
  void keepAlong(float distance, std::uint32_t count, float angular_resolution, Visit&& visit) {
    if (count == 0) return;
    count = std::min(count, diameters_ + 1);
    findChances(distance, count, 1.0F / angular_resolution);
    kept_.resize(std::max<std::size_t>(kept_.size(), count + 1));
    // Without branches: which candidates stay is hard to foretell.
    auto sum = static_cast<std::uint32_t>(random_.next() >> 32);
    std::uint32_t* end = kept_.data();
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t next = sum + static_cast<std::uint32_t>(chances_[i]);
      *end = i;
      end += (sum ^ next) / kOne & 1U;  // whether it came past a multiple of kOne
      sum = next;
    }
    std::for_each(kept_.data(), end, visit);
  }

 private:
  static constexpr std::uint32_t kStepsPerDiameter = 16;
  static constexpr std::uint32_t kOne = 1U << 30U;  // a chance of 1: numbers of a fixed point add up in one step

  // Of candidates that far from the sensor: it and all that lie whole diameters nearer follow one another, down to the sensor.
  // Beyond the greatest distance, as floats round it thousands of kilometres from the map's origin, as there.
  const float* touchingAngles(float distance) const {
    assert(distance >= 0.0F);
    const auto step = static_cast<std::uint32_t>(distance * steps_per_metre_);
    const std::uint32_t diameters = std::min(step / kStepsPerDiameter, diameters_ - 1);
    return touching_angles_.data() + step % kStepsPerDiameter * (diameters_ + 1) + (diameters_ - 1 - diameters);
  }

  void findProbabilities(const std::vector<float>& distances, const std::vector<float>& rays_per_radian);

  // Of the candidates of the ray at hand, in fractions of kOne.
  void findChances(float distance, std::uint32_t count, float rays_per_radian);

  float lambda_;
  float steps_per_metre_;
  std::uint32_t diameters_;             // to the farthest
  std::vector<float> touching_angles_;  // for each fraction of a diameter: by whole ones, from far to the sensor itself
  std::vector<float> probabilities_;    // of the candidates at hand
  std::vector<std::int32_t> chances_;   // of the ray at hand
  std::vector<std::uint32_t> kept_;     // of either
  Random& random_;
};

}  // namespace atom_map
