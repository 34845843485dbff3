// Least squares planes over a few points, quick enough to be fitted to every return.
#pragma once

#include <Eigen/Core>

#include "atom_mapping/scan/neighborhood.h"

namespace atom_map {

// Of a return, which weighs 1, and its neighbours.
struct Moments {
  Eigen::Vector3f mean;  // relative to the return
  Eigen::Matrix3f covariance;
};

Moments momentsOf(const Neighborhood& neighbors, const Neighborhood::Floats& weight);

struct PlaneFit {
  Eigen::Vector3f normal;  // unit, of either sign
  float breadth;  // m, standard deviation along the shorter axis of the plane; 0 where there is none, nor a normal
};

// Of points whose variance across the plane is far below those along it.
PlaneFit fitPlane(const Eigen::Matrix3f& covariance);

}  // namespace atom_map
