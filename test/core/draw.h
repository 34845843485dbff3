// Random draws for tests, made of the core's own generator: the same on every platform.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "atom_mapping/base/random.h"

namespace atom_map {

inline float draw(Random& random, float low, float high) {
  return low + (high - low) * random.uniform();
}

// From 0 to count - 1.
inline std::size_t drawIndex(Random& random, std::size_t count) {
  return random.next() % count;
}

inline Eigen::Vector3f drawIn(Random& random, const Eigen::AlignedBox3f& box) {
  Eigen::Vector3f point;
  for (int axis = 0; axis < 3; ++axis) point[axis] = draw(random, box.min()[axis], box.max()[axis]);
  return point;
}

// In a cube about the origin.
inline Eigen::Vector3f drawWithin(Random& random, float half) {
  return drawIn(random, {Eigen::Vector3f::Constant(-half), Eigen::Vector3f::Constant(half)});
}

inline Eigen::Vector3f drawDirection(Random& random) {
  const float z = draw(random, -1.0F, 1.0F);
  const float azimuth = draw(random, 0.0F, 6.2831853F);
  const float level = std::sqrt(1.0F - z * z);
  return {level * std::cos(azimuth), level * std::sin(azimuth), z};
}

// Normal, with mean 0 and standard deviation 1 (Box and Muller 1958).
inline float drawGaussian(Random& random) {
  const float radius = std::sqrt(-2.0F * std::log(1.0F - random.uniform()));
  return radius * std::cos(6.2831853F * random.uniform());
}

inline Eigen::Vector3f drawGaussianVector(Random& random) {
  Eigen::Vector3f vector;
  for (int axis = 0; axis < 3; ++axis) vector[axis] = drawGaussian(random);
  return vector;
}

// A rotation about a general axis and a translation of up to `half` along each axis.
inline Eigen::Isometry3d drawPose(Random& random, double half) {
  const Eigen::Vector3d axis = drawDirection(random).cast<double>().normalized();
  const Eigen::Vector3d place = half * drawWithin(random, 1.0F).cast<double>();
  const auto angle = static_cast<double>(draw(random, 0.0F, 3.0F));
  return Eigen::Translation3d(place) * Eigen::AngleAxisd(angle, axis);
}

}  // namespace atom_map
