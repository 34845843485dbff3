// Gaussian-process regression of what the atoms store (paper III-F), which also serves signed distances (paper IV).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/map/atom_map.h"

namespace atom_map {

struct Estimate {
  float value;               // log-odds of occupancy, or signed distance in metres
  float variance;            // of the value (Eq. 8), same unit squared
  Eigen::Vector3f gradient;  // of the value, per metre
};

// Regression at points of a map's local frame, trained on the N nearest atoms. One object serves one thread: it keeps
// its memory from query to query.
class GaussianProcess {
 public:
  // The map must outlive this; `parameters` must be in their ranges.
  GaussianProcess(const AtomMap& map, const GaussianProcessParameters& parameters);

  static constexpr float kKnownReach = 2.0F;  // radii

  // Nothing where no atom's centre lies within known_reach radii: unknown. It must not be greater than 4.
  // Choice: the training atoms are those of the N nearest within four radii. Signed distances are regressed about their
  // mean, as the paper's zero mean would draw the distance far from a surface towards it; and an atom's own variance
  // (Eq. 11) adds to the noise, so that what was seen once tells less than what was seen often.
  std::optional<Estimate> estimate(const Eigen::Vector3f& point, float known_reach = kKnownReach);

 private:
  const AtomMap& map_;
  GaussianProcessParameters parameters_;
  std::vector<Neighbor> neighbors_;
};

}  // namespace atom_map
