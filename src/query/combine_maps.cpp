#include "atom_mapping/query/combine_maps.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "atom_mapping/query/gaussian_process.h"
#include "atom_mapping/scan/snap.h"

namespace atom_map {
namespace {

// The other map's atoms where they lie in the map, made by make(atom, centre); those behind surfaces first.
template <class Told, class Make, class IsBehind>
std::vector<Told> toldBy(const AtomMap& other, const AtomMap& map, const Make& make, const IsBehind& is_behind) {
  std::vector<Told> told;
  told.reserve(other.atoms().size());
  other.atoms().forEach(
      [&](const ConstAtomRef& atom) { told.push_back(make(atom, map.toLocal(other.toMap(atom.center())))); });
  std::stable_partition(told.begin(), told.end(), is_behind);
  snapToLattice(told, map.radius());
  return told;
}

// Choice: where the regression makes the distance steeper than one can be, as at edges, its slope is 1.
Eigen::Vector3f gradientAt(const Eigen::Vector3f& center, GaussianProcess& field) {
  const Eigen::Vector3f gradient = field.estimate(center)->gradient;  // the atom itself makes it known
  return gradient / std::max(1.0F, gradient.norm());
}

template <class Merging, class Told>
MergeReport merged(Merging merging, const std::vector<Told>& told) {
  merging.add(told.data(), told.data() + told.size());
  return merging.report();
}

MergeReport mergeOccupancy(AtomMap& map, const AtomMap& other, const OccupancyParameters& parameters) {
  const auto told = toldBy<Candidate>(
      other, map,
      [](const ConstAtomRef& atom, const auto& center) {
        return Candidate{center, atom.value()};
      },
      [](const Candidate& candidate) { return candidate.value > 0.0F; });
  return merged(OccupancyMerge(map, parameters), told);
}

MergeReport mergeDistances(AtomMap& map, const AtomMap& other, const MappingParameters& parameters) {
  GaussianProcess field(other, parameters.gaussian_process);
  const auto told = toldBy<ToldDistance>(
      other, map,
      [&](const ConstAtomRef& atom, const auto& center) {
        return ToldDistance{{center, atom.value(), gradientAt(atom.center(), field)}, atom.value(1)};
      },
      [](const ToldDistance& atom) { return atom.distance < 0.0F; });
  return merged(DistanceMerge(map, parameters.signed_distance), told);
}

}  // namespace

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

MergeReport mergeInto(AtomMap& map, const AtomMap& other, const MappingParameters& parameters) {
  assert(map.mode() == other.mode() && map.radius() == other.radius());
  map.anchor(other.origin());
  return map.mode() == Mode::kOccupancy ? mergeOccupancy(map, other, parameters.occupancy)
                                        : mergeDistances(map, other, parameters);
}

}  // namespace atom_map
