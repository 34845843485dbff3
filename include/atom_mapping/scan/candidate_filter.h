// Stage 5: the voxel-grid filter that the paper proposes for the candidates that interleaving leaves (III-D).
#pragma once

#include "atom_mapping/scan/normal_rays.h"
#include "atom_mapping/scan/rays.h"

namespace atom_map {

// Keeps one candidate a cubic cell of cell_size metres, the first of its kind.
// Choice: an occupied candidate is never lost to a free one, or thin things vanish.
// Choice: those that stay are ordered by blocks of 4 x 4 x 4 cells, so that merging finds the tree's leaves in the
// processor's cache.
Candidates filterCandidates(const Candidates& candidates, float cell_size);

// The same in signed distance mode: behind the surface before in front of it, and near it before far from it.
DistanceCandidates filterCandidates(const DistanceCandidates& candidates, float cell_size);

}  // namespace atom_map
