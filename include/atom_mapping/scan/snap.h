// Candidates' centres on a lattice, far finer than any sensor's noise.
//
// Choice: the paper has centres wherever a ray puts them. What a float tells of them beyond 0.1 % of a radius is noise, which
// no compression shortens: without it a map file takes 9 to 10 bytes an atom in place of 12 to 13.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace atom_map {

// m; a power of two, so that floats hold multiples of it exactly, up to 16 million of them.
inline float latticeSpacing(float radius) {
  return std::exp2(std::floor(std::log2(radius / 1024.0F)));
}

inline Eigen::Vector3f snapped(const Eigen::Vector3f& point, float spacing) {
  return spacing * (point / spacing).array().rint();
}

template <class AnyCandidate>
void snapToLattice(std::vector<AnyCandidate>& candidates, float radius) {
  const float spacing = latticeSpacing(radius);
  for (AnyCandidate& candidate : candidates) {
    candidate.center = snapped(candidate.center, spacing);
  }
}

}  // namespace atom_map
