#include "atom_mapping/map/drop_crossing.h"

#include <algorithm>

#include "atom_mapping/map/atom_tree.h"

namespace atom_map {

void dropCrossing(const std::vector<SurfacePoint>& surface, float radius, float noise,
                  std::vector<DistanceCandidate>& infront) {
  constexpr float kSlack = 0.1F;  // of the distance: curved surfaces come nearer than their tangent planes
  AtomTree points(radius, 1);
  for (const SurfacePoint& point : surface) {
    const float unused = 0.0F;
    points.insert(point.position, &unused);
  }
  const auto crosses = [&](const DistanceCandidate& candidate) {
    const float clearance = (1.0F - kSlack) * candidate.distance - 3.0F * noise;
    return clearance > 0.0F && points.nearest(candidate.center, clearance).has_value();
  };
  infront.erase(std::remove_if(infront.begin(), infront.end(), crosses), infront.end());
}

}  // namespace atom_map
