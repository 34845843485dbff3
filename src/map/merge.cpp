#include "atom_mapping/map/merge.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "atom_mapping/map/overlap.h"

namespace atom_map {

OccupancyMerge::OccupancyMerge(AtomMap& map, const OccupancyParameters& parameters)
    : diameter_(2.0F * map.radius()),
      vicinity_(map.atoms(), AtomMap::kOverlapTolerance * diameter_, kBlock * diameter_),
      max_log_odds_(static_cast<float>(parameters.max_log_odds)) {
  assert(map.mode() == Mode::kOccupancy);
}

void OccupancyMerge::add(const Candidate* begin, const Candidate* end) {
  vicinity_.forget();
  std::for_each(begin, end, [this](const Candidate& candidate) { add(candidate); });
}

void OccupancyMerge::add(const Candidate& candidate) {
  const bool occupied = candidate.value > 0.0F;
  bool overlaps = false;
  vicinity_.forEachWithin(candidate.center, [&](AtomRef atom, float squared_distance) {
    overlaps = true;
    if (occupied && squared_distance < candidate.hold * candidate.hold) held_.insert(atom.center());
    if (!occupied && held_.contains(atom.center())) return;
    const float overlap = overlapFraction(std::sqrt(squared_distance) / diameter_);
    const float log_odds = atom.value() + overlap * candidate.value;  // Eq. (3)
    atom.value() = std::clamp(log_odds, -max_log_odds_, max_log_odds_);
    ++report_.updates;
  });
  if (overlaps) return;
  const float log_odds = std::clamp(candidate.value, -max_log_odds_, max_log_odds_);
  vicinity_.insert(candidate.center, &log_odds);
  if (occupied) held_.insert(candidate.center);
  ++report_.inserted;
}

}  // namespace atom_map
