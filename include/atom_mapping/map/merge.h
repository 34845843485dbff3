// Merging one scan's candidates into the map (paper III-E): the only code that writes atoms.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/base/types.h"
#include "atom_mapping/map/atom_map.h"
#include "atom_mapping/map/center_set.h"
#include "atom_mapping/map/map_limit.h"
#include "atom_mapping/map/vicinity.h"
#include "atom_mapping/scan/normal_rays.h"

namespace atom_map {

struct MergeReport {
  std::uint32_t inserted = 0;  // candidates that became atoms
  std::uint32_t refused = 0;   // candidates that would have, had the map not been full
  std::uint32_t updates = 0;   // changes of atoms that were there
};

// Merges the candidates of one scan. They may come in several calls, occupied ones before free ones, so that a server
// can let readers and other writers in between.
// Choice: an atom that a return of this scan raised is not lowered by the same scan's rays passing by, as in OctoMap;
// but only near the return's own atom, or the free atoms in front of a surface would never grow sure and the surface
// between them and the occupied ones would lie too far out.
// Choice: where none of the atoms that a thin thing's candidate overlaps lies within a radius of it, it is pushed out of them, by
// a radius at most, and inserted beside them if there is room. Otherwise a pole would be told by an atom up to two radii off.
// Choice: a free candidate that overlaps a lone atom by little is pushed out of it likewise. Of the holes that chance leaves
// in space that rays crossed, most lie beside such an atom: it fills nine in ten.
class OccupancyMerge {
 public:
  // The map must be in occupancy mode, and outlive this. A map that reaches `limit` gets no new atoms.
  OccupancyMerge(AtomMap& map, const OccupancyParameters& parameters, const MapLimit& limit = {});

  // Candidates in the map's local frame; their values are log-odds.
  void add(const Candidate* begin, const Candidate* end);

  const MergeReport& report() const { return report_; }

 private:
  // What a candidate overlaps, and how far (m) it must move to be clear of each alone.
  struct Overlaps {
    int count = 0;
    float nearest = std::numeric_limits<float>::infinity();  // m, to a centre
    Eigen::Vector3f push = Eigen::Vector3f::Zero();

    void add(const Eigen::Vector3f& from_atom, float distance, float diameter);
  };

  void add(const Candidate& candidate);
  Overlaps updateOverlapped(const Candidate& candidate);
  bool mayStandAside(const Candidate& candidate, const Overlaps& overlaps) const;
  void addAside(const Candidate& candidate, const Eigen::Vector3f& push);
  void insert(const Candidate& candidate);

  const AtomTree& atoms_;
  MapLimit limit_;
  float diameter_;  // m, of an atom
  float lattice_;   // m, spacing of the atoms' centres
  Vicinity vicinity_;
  float max_log_odds_;
  CenterSet held_;
  MergeReport report_;
};

// An atom of another map, as it comes to this one; its normal is the gradient of the other map's field there.
struct ToldDistance : DistanceCandidate {
  float variance;  // m^2, its own
};

// Merges the candidates of one scan in signed distance mode by Eq. (9) to (11).
// Choice: what a candidate tells of an atom that it overlaps is the distance at the atom's centre, which differs from
// the one at the candidate's own by their offset along the normal. The paper leaves that offset as an error of up to 2r.
// Choice: an atom of another map counts by the inverse of its own variance, times the overlap: one that many candidates made
// is surer than one candidate, and what it knows is not told in full to each of the atoms that it overlaps. With Eq. (9)'s
// weights, which give an atom that it only just touches a third, the distances of the campus grew less true by merging.
class DistanceMerge {
 public:
  // As OccupancyMerge, in signed distance mode.
  DistanceMerge(AtomMap& map, const SignedDistanceParameters& parameters, const MapLimit& limit = {});

  // Candidates in the map's local frame; their distances must not be 0, which Eq. (9) would trust without bounds.
  void add(const DistanceCandidate* begin, const DistanceCandidate* end);
  // The same of another map's atoms, of any distance.
  void add(const ToldDistance* begin, const ToldDistance* end);

  const MergeReport& report() const { return report_; }

 private:
  template <class Variance>
  void add(const DistanceCandidate& candidate, const Variance& variance);

  const AtomTree& atoms_;
  MapLimit limit_;
  float diameter_;  // m, of an atom
  Vicinity vicinity_;
  float xi_;
  MergeReport report_;
};

}  // namespace atom_map
