// Maps as wholes: moved, and merged into one, as those of several robots or days.
#pragma once

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/base/types.h"
#include "atom_mapping/map/atom_map.h"
#include "atom_mapping/map/merge.h"

namespace atom_map {

// The map's atoms in another frame, each with what it stores: nothing is sampled anew, so that there and back is the same map
// but for the rounding of floats. `pose`: the map's frame to the other, a rotation and a translation.
AtomMap transformed(const AtomMap& map, const Pose& pose);

// Merges another map's atoms as if they were the candidates of one scan (paper III-E): those behind surfaces first, each with
// its log-odds, or its signed distance and variance (see DistanceMerge). Both maps must be of one mode and radius, and in one
// frame.
MergeReport mergeInto(AtomMap& map, const AtomMap& other, const MappingParameters& parameters);

}  // namespace atom_map
