// Stage 3: candidates along the ray and the normal of each surface point (paper III-C).
#pragma once

#include <vector>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/base/random.h"
#include "atom_mapping/base/types.h"

namespace atom_map {

struct Candidates {
  std::vector<Candidate> occupied;  // step A, behind the surface
  std::vector<Candidate> free;      // step B or C
  std::uint64_t proposed = 0;       // before interleaving

  std::size_t size() const { return occupied.size() + free.size(); }
};

// Steps A and B with interleaving. `sensor` is the sensor's position, in the frame of the surface points;
// `no_returns` are unit directions of rays to be freed to scan/max_range, in the same frame.
Candidates traceRays(const std::vector<SurfacePoint>& surface, const std::vector<Eigen::Vector3f>& no_returns,
                     const Eigen::Vector3f& sensor, const MappingParameters& parameters, Random& random);

}  // namespace atom_map
