#pragma once

#include <Eigen/Core>

#include "atom_mapping/scan/neighborhood.h"

namespace atom_map {

// What a normal was fitted to.
enum class Fit {
  kPlane,
  kLine,  // all that agree lie on one line: the normal is square to it, else as the ray
  kNone   // nothing agrees: the normal is the ray's direction
};

struct Normal {
  Eigen::Vector3f direction;  // unit, turned towards the sensor
  Fit fit;
  float offset = 0.0F;  // m along the direction, from the return to the plane that was fitted
};

// cosine between normal and ray: a plane seen more obliquely is the edge of a step
constexpr float kMinFacing = 0.05F;

// Of a return, by its neighbours. `towards_sensor` is the unit direction from the return; `noise` (m) the standard deviation of
// a range.
//
// Choice: where nearly all neighbours lie on one plane that is the plane. Elsewhere it is the one that most of them agree on (least
// sum of truncated squared distances over planes through the return and two of them), refined by least squares over
// those that agree. So edges, steps and thin things keep the plane of their own side.
Normal estimateNormal(const Neighborhood& neighbors, const Eigen::Vector3f& towards_sensor, float noise);

}  // namespace atom_map
