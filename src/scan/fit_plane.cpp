#include "atom_mapping/scan/fit_plane.h"

#include <Eigen/Geometry>
#include <cmath>

namespace atom_map {

Moments momentsOf(const Neighborhood& neighbors, const Neighborhood::Floats& weight) {
  const Neighborhood::Floats x = weight * neighbors.x;
  const Neighborhood::Floats y = weight * neighbors.y;
  const Neighborhood::Floats z = weight * neighbors.z;
  const float weights = 1.0F + weight.sum();
  const Eigen::Vector3f mean = Eigen::Vector3f(x.sum(), y.sum(), z.sum()) / weights;
  const float xy = (x * neighbors.y).sum();
  const float xz = (x * neighbors.z).sum();
  const float yz = (y * neighbors.z).sum();
  Eigen::Matrix3f squares;
  squares << (x * neighbors.x).sum(), xy, xz, xy, (y * neighbors.y).sum(), yz, xz, yz, (z * neighbors.z).sum();
  return {mean, squares / weights - mean * mean.transpose()};
}

// The adjugate of a covariance with variances a < b < c is bc times the projection onto the axis of a, and ab, ac times
// those onto the others: its columns are the normal with an error of a / b, and a / b squared once it is applied again.
PlaneFit fitPlane(const Eigen::Matrix3f& covariance) {
  const float trace = covariance.trace();
  const Eigen::Matrix3f scaled =
      covariance / trace;  // floats do not reach down to the eighth powers of small distances
  Eigen::Matrix3f adjugate;
  for (int axis = 0; axis < 3; ++axis) {
    adjugate.col(axis) = scaled.col((axis + 1) % 3).cross(scaled.col((axis + 2) % 3));
  }
  int largest = 0;
  if (!(adjugate.diagonal().maxCoeff(&largest) > 1e-6F)) return {Eigen::Vector3f::Zero(), 0.0F};
  return {(adjugate * adjugate.col(largest)).normalized(), std::sqrt(adjugate.trace() * trace)};
}

}  // namespace atom_map
