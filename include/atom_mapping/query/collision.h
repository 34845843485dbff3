#pragma once

#include "atom_mapping/map/atom_map.h"

namespace atom_map {

// Whether a sphere collides: overlaps an occupied atom or, unless unknown is free, reaches into unknown space. Center
// in the map's local frame, radius in metres from zero on; both finite.
//
// Choice: unknown space is searched at the points of a cubic lattice about the center, no farther apart than an atom's
// radius and with the sphere's six poles among them. So a hole that a search misses is narrower than an atom; and a
// sphere that leaves the map fails at its first points. Costs O((sphere's radius / atom's radius)^3).
bool collides(const AtomMap& map, const Eigen::Vector3f& center, float radius, bool unknown_is_free);

}  // namespace atom_map
