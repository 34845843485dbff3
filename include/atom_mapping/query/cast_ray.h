#pragma once

#include "atom_mapping/map/atom_map.h"

namespace atom_map {

enum class RayEnd { kMiss = 0, kHit = 1, kUnknown = 2 };

struct CastRay {
  RayEnd end;
  float distance;  // m along the ray, to where it ended
};

// Follows a ray through free space: to the first occupied point, to where it enters unknown space, or to max_range,
// whichever comes first. Origin in the map's local frame, finite; unit direction; max_range in metres from zero on, may
// be infinite.
//
// Choice: Eq. (5) is asked every half radius, and the end then found by bisection to a hundredth of a radius. What a
// sphere of one radius stands for is wider than a step, save at its rim. Costs O(log(atoms)) a step; unknown space
// around the map ends every ray.
CastRay castRay(const AtomMap& map, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float max_range);

}  // namespace atom_map
