// Stochastic angular interleaving (paper III-D): rays crowd near the sensor, so only some candidates stay, at random,
// such that about one of those that overlap one another does.
#pragma once

#include <vector>

#include "atom_mapping/base/random.h"

namespace atom_map {

// Angle at the sensor between two atoms of a radius, touching one another at a distance from it; pi where the sensor
// lies within them. Radians.
float touchingAngle(float radius, float distance);

// Number of candidates that overlap one, itself included, of rays that lie an angle (radians) apart: Eq. (1).
float overlapCount(float touching_angle, float angular_resolution);

// Probability with which each of k overlapping candidates stays: Eq. (2).
float keepProbability(float k, float lambda);

// Draws for the candidates of one scan.
class Interleaver {
 public:
  // Candidates may be asked for up to max_distance (m) from the sensor.
  Interleaver(float radius, float lambda, float max_distance, Random& random);

  // Whether the candidate at a distance from the sensor stays, among rays that lie angular_resolution (radians) apart.
  bool keep(float distance, float angular_resolution);

 private:
  float lambda_;
  float steps_per_metre_;
  std::vector<float> touching_angles_;  // over distance
  Random& random_;
};

}  // namespace atom_map
