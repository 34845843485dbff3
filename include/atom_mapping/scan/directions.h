#pragma once

#include <Eigen/Core>
#include <vector>

namespace atom_map {

// Of points in the sensor frame, one of each a point. Radians with an error of at most 4e-6.
struct Directions {
  std::vector<float> elevation;
  std::vector<float> azimuth;  // from -pi to pi
  std::vector<float> range;    // m
};
Directions directionsOf(const std::vector<Eigen::Vector3f>& points);

}  // namespace atom_map
