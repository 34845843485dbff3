#include "atom_mapping/scan/drop_crossing.h"

#include <algorithm>
#include <cmath>

#include "atom_mapping/scan/point_boxes.h"

namespace atom_map {

void dropCrossing(const std::vector<SurfacePoint>& surface, float noise, DistanceCandidates& candidates) {
  constexpr float kSlack = 0.1F;  // of the distance: curved surfaces come nearer than their tangent planes
  const PointBoxes points(surface);
  const auto crosses = [&](const DistanceCandidate& candidate) {
    const float clearance = (1.0F - kSlack) * std::abs(candidate.distance) - 3.0F * noise;
    return clearance > 0.0F && points.isAnyWithin(candidate.center, clearance);
  };
  for (auto* side : {&candidates.behind, &candidates.infront}) {
    side->erase(std::remove_if(side->begin(), side->end(), crosses), side->end());
  }
}

}  // namespace atom_map
