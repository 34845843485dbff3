// The merge of paper III-E on a plain list of atoms, as the paper and the header of merge.h say it.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/base/types.h"
#include "draw.h"

namespace atom_map {

constexpr float kRadius = 0.25F;  // m, of the atoms

// One scan's candidates, crowded: occupied ones on a surface, free ones before it.
struct Scan {
  std::vector<Candidate> occupied;
  std::vector<Candidate> free;
};

inline Scan drawScan(Random& random, float half) {
  const float hold = draw(random, 0.0F, 2.0F * kRadius);
  Scan scan;
  for (int i = 0; i < 150; ++i) {
    const Eigen::Vector3f center = drawWithin(random, half);
    scan.occupied.push_back({{center.x(), center.y(), 0.1F * center.z()}, 0.8F, hold});
  }
  for (int i = 0; i < 300; ++i) scan.free.push_back({drawWithin(random, half), -0.4F});
  return scan;
}

// Centre and log-odds.
using SortedAtoms = std::vector<std::array<float, 4>>;

class ListMerge {
 public:
  explicit ListMerge(const OccupancyParameters& parameters) : parameters_(parameters) {}

  void add(const Scan& scan) {
    for (Atom& atom : atoms_) atom.held = false;
    for (const Candidate& candidate : scan.occupied) add(candidate);
    for (const Candidate& candidate : scan.free) add(candidate);
  }

  SortedAtoms atoms() const {
    SortedAtoms atoms;
    for (const Atom& atom : atoms_) atoms.push_back({atom.center.x(), atom.center.y(), atom.center.z(), atom.log_odds});
    std::sort(atoms.begin(), atoms.end());
    return atoms;
  }

 private:
  struct Atom {
    Eigen::Vector3f center;
    float log_odds;
    bool held;  // raised by this scan: not to be lowered by it
  };

  void add(const Candidate& candidate) {
    const auto max = static_cast<float>(parameters_.max_log_odds);
    const bool occupied = candidate.value > 0.0F;
    bool overlaps = false;
    for (Atom& atom : atoms_) {
      const float distance = (atom.center - candidate.center).norm();
      if (distance >= 0.999F * 2.0F * kRadius) continue;
      overlaps = true;
      if (occupied && distance < candidate.hold) atom.held = true;
      if (!occupied && atom.held) continue;
      const float overlap = 1.0F - distance / (4.0F * kRadius * kRadius * kRadius) *
                                       (3.0F * kRadius * kRadius - distance * distance / 4.0F);  // Eq. (4)
      atom.log_odds = std::clamp(atom.log_odds + overlap * candidate.value, -max, max);          // Eq. (3)
    }
    if (!overlaps) atoms_.push_back({candidate.center, std::clamp(candidate.value, -max, max), occupied});
  }

  OccupancyParameters parameters_;
  std::vector<Atom> atoms_;
};

}  // namespace atom_map
