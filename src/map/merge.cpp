#include "atom_mapping/map/merge.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "atom_mapping/base/cell_set.h"
#include "atom_mapping/map/overlap.h"
#include "atom_mapping/scan/snap.h"

namespace atom_map {

OccupancyMerge::OccupancyMerge(AtomMap& map, const OccupancyParameters& parameters, const MapLimit& limit)
    : atoms_(map.atoms()),
      limit_(limit),
      diameter_(2.0F * map.radius()),
      lattice_(latticeSpacing(map.radius())),
      vicinity_(map.atoms(), AtomMap::kOverlapTolerance * diameter_, CellSet::kBlock * diameter_),
      max_log_odds_(static_cast<float>(parameters.max_log_odds)) {
  assert(map.mode() == Mode::kOccupancy);
}

void OccupancyMerge::add(const Candidate* begin, const Candidate* end) {
  vicinity_.forget();
  std::for_each(begin, end, [this](const Candidate& candidate) { add(candidate); });
}

void OccupancyMerge::add(const Candidate& candidate) {
  const Overlaps overlaps = updateOverlapped(candidate);
  if (overlaps.count == 0) {
    insert(candidate);
  } else if (mayStandAside(candidate, overlaps)) {
    addAside(candidate, overlaps.push);
  }
}

bool OccupancyMerge::mayStandAside(const Candidate& candidate, const Overlaps& overlaps) const {
  constexpr float kFar = 0.7F;  // diameters, of a lone atom: who stands aside further may stand in a surface
  if (candidate.aside == Aside::kOfOne) return overlaps.count == 1 && overlaps.nearest > kFar * diameter_;
  return candidate.aside == Aside::kOfAll && overlaps.nearest > 0.5F * diameter_;
}

OccupancyMerge::Overlaps OccupancyMerge::updateOverlapped(const Candidate& candidate) {
  const bool occupied = candidate.value > 0.0F;
  Overlaps overlaps;
  vicinity_.forEachWithin(candidate.center, [&](AtomRef atom, float squared_distance) {
    const float distance = std::sqrt(squared_distance);
    overlaps.add(candidate.center - atom.center(), distance, diameter_);
    if (occupied && distance < candidate.hold) held_.insert(atom.center());
    // At the clamp it was not raised, and cannot be lowered.
    if (!occupied && (atom.value() == -max_log_odds_ || held_.contains(atom.center()))) return;
    const float log_odds = atom.value() + overlapFraction(distance / diameter_) * candidate.value;  // Eq. (3)
    atom.setValue(0, std::clamp(log_odds, -max_log_odds_, max_log_odds_));
    ++report_.updates;
  });
  return overlaps;
}

void OccupancyMerge::addAside(const Candidate& candidate, const Eigen::Vector3f& push) {
  if (push.norm() > 0.5F * diameter_) return;
  Candidate aside = candidate;
  aside.center = snapped(candidate.center + push, lattice_);
  bool is_clear = true;
  vicinity_.forEachWithin(aside.center, [&](AtomRef, float) { is_clear = false; });
  if (is_clear) insert(aside);
}

void OccupancyMerge::insert(const Candidate& candidate) {
  if (!limit_.hasRoom(atoms_)) {
    ++report_.refused;
    return;
  }
  const float log_odds = std::clamp(candidate.value, -max_log_odds_, max_log_odds_);
  vicinity_.insert(candidate.center, &log_odds);
  if (candidate.value > 0.0F) held_.insert(candidate.center);
  ++report_.inserted;
}

void OccupancyMerge::Overlaps::add(const Eigen::Vector3f& from_atom, float distance, float diameter) {
  ++count;
  nearest = std::min(nearest, distance);
  if (distance > 0.0F) push += (diameter / distance - 1.0F) * from_atom;
}

}  // namespace atom_map
