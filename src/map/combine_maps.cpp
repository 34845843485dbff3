#include "atom_mapping/map/combine_maps.h"

#include <array>
#include <cassert>
#include <vector>

#include "atom_mapping/scan/snap.h"

namespace atom_map {

AtomMap transformed(const AtomMap& map, const Pose& pose) {
  AtomMap moved(map.mode(), static_cast<double>(map.radius()));
  moved.anchor(pose * map.origin());
  const bool has_variance = map.mode() == Mode::kSignedDistance;
  map.atoms().forEach([&](const ConstAtomRef& atom) {
    const std::array<float, 2> values{atom.value(), has_variance ? atom.value(1) : 0.0F};
    moved.atoms().insert(moved.toLocal(pose * map.toMap(atom.center())), values.data());
  });
  return moved;
}

MergeReport mergeInto(AtomMap& map, const AtomMap& other, const OccupancyParameters& parameters) {
  assert(map.mode() == other.mode() && map.radius() == other.radius());
  map.anchor(other.origin());
  std::vector<Candidate> occupied;
  std::vector<Candidate> free;
  other.atoms().forEach([&](const ConstAtomRef& atom) {
    const Candidate candidate{map.toLocal(other.toMap(atom.center())), atom.value()};
    (candidate.value > 0.0F ? occupied : free).push_back(candidate);
  });
  snapToLattice(occupied, map.radius());
  snapToLattice(free, map.radius());
  OccupancyMerge merging(map, parameters);
  merging.add(occupied.data(), occupied.data() + occupied.size());
  merging.add(free.data(), free.data() + free.size());
  return merging.report();
}

}  // namespace atom_map
