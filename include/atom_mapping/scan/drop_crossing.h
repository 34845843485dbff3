#pragma once

#include <vector>

#include "atom_mapping/base/types.h"
#include "atom_mapping/scan/normal_rays.h"

namespace atom_map {

// Removes the candidates that may lie beyond a surface which another point of the same scan saw (paper III-C, step C):
// those with a surface point nearer than the distance that they carry, less what the range's noise (m) explains.
// Choice: those of step A as well, which would carry too great a distance near the edges of things.
// Everything in one frame.
void dropCrossing(const std::vector<SurfacePoint>& surface, float noise, DistanceCandidates& candidates);

}  // namespace atom_map
