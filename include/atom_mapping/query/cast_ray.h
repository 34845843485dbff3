#pragma once

#include "atom_mapping/map/atom_map.h"
#include "atom_mapping/query/gaussian_process.h"

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
// Choice: Eq. (5) is asked every quarter radius, and the end then found by bisection to a hundredth of a radius. What a
// sphere of one radius stands for is wider than a step, save at its rim. Where all atoms less than 2r away are free it
// need not be asked. Costs O(log(atoms)) for some radii of the way; unknown space around the map ends every ray.
CastRay castRay(const AtomMap& map, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float max_range);

// The same of a map in signed distance mode: by the sign of the regressed distance.
// Choice: the regression is not asked where an atom's own distance, less the way to it and a radius, is positive and
// no atom less than 2r away lies within a surface.
CastRay castRay(const AtomMap& map, GaussianProcess& distances, const Eigen::Vector3f& origin,
                const Eigen::Vector3f& direction, float max_range);

}  // namespace atom_map
