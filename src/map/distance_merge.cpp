#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "atom_mapping/base/cell_set.h"
#include "atom_mapping/map/merge.h"
#include "atom_mapping/map/overlap.h"

namespace atom_map {

DistanceMerge::DistanceMerge(AtomMap& map, const SignedDistanceParameters& parameters, const MapLimit& limit)
    : atoms_(map.atoms()),
      limit_(limit),
      diameter_(2.0F * map.radius()),
      vicinity_(map.atoms(), AtomMap::kOverlapTolerance * diameter_, CellSet::kBlock * diameter_),
      xi_(static_cast<float>(parameters.xi)) {
  assert(map.mode() == Mode::kSignedDistance);
}

void DistanceMerge::add(const DistanceCandidate* begin, const DistanceCandidate* end) {
  vicinity_.forget();
  std::for_each(begin, end, [this](const DistanceCandidate& candidate) {
    add(candidate, [&](float overlap) {
      return candidate.distance * candidate.distance / (xi_ + overlap);  // Eq. (9)
    });
  });
}

void DistanceMerge::add(const ToldDistance* begin, const ToldDistance* end) {
  vicinity_.forget();
  std::for_each(begin, end, [this](const ToldDistance& atom) {
    add(atom, [&](float overlap) { return atom.variance / overlap; });
  });
}

// `variance` of what it tells of an atom, by their overlap.
template <class Variance>
void DistanceMerge::add(const DistanceCandidate& candidate, const Variance& variance) {
  bool overlaps = false;
  vicinity_.forEachWithin(candidate.center, [&](AtomRef atom, float squared_distance) {
    overlaps = true;
    const float overlap = overlapFraction(std::sqrt(squared_distance) / diameter_);
    const float told = candidate.distance + candidate.normal.dot(atom.center() - candidate.center);
    const float sum = variance(overlap) + atom.value(1);
    const float gain = sum > 0.0F ? atom.value(1) / sum : 0.0F;
    atom.setValue(0, atom.value(0) + gain * (told - atom.value(0)));  // Eq. (10)
    atom.setValue(1, atom.value(1) * (1.0F - gain));                  // Eq. (11)
    ++report_.updates;
  });
  if (overlaps) return;
  if (!limit_.hasRoom(atoms_)) {
    ++report_.refused;
    return;
  }
  const std::array<float, 2> values{candidate.distance, variance(1.0F)};
  vicinity_.insert(candidate.center, values.data());
  ++report_.inserted;
}

}  // namespace atom_map
