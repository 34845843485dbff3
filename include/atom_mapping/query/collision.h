#pragma once

#include "atom_mapping/map/atom_map.h"
#include "atom_mapping/query/gaussian_process.h"

namespace atom_map {

// Whether a sphere collides: overlaps an occupied atom, reaches into what Eq. (5) calls occupied between atoms or, unless
// unknown is free, reaches into unknown space. Center in the map's local frame, radius in metres from zero on; both
// finite. Costs O((sphere's radius / atom's radius)^3).
//
// Choice: between atoms, Eq. (5) is asked where the sphere comes nearest to an occupied atom less than 2r away: atoms are
// tangent to a surface, so that a small sphere may stand in it and overlap none of them.
// Choice: unknown space is searched at the points of a cubic lattice about the center, no farther apart than an atom's
// radius and with the sphere's six poles among them. So a hole that a search misses is narrower than an atom; and a
// sphere that leaves the map fails at its first points.
bool collides(const AtomMap& map, const Eigen::Vector3f& center, float radius, bool unknown_is_free);

// The same of a map in signed distance mode, where a regressed distance below the radius is a collision as well.
bool collides(const AtomMap& map, GaussianProcess& distances, const Eigen::Vector3f& center, float radius,
              bool unknown_is_free);

}  // namespace atom_map
