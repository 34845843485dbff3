// Stage 3 in signed distance mode: candidates along the surface normals (paper III-C, steps A and C).
#pragma once

#include <cstdint>
#include <vector>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/base/random.h"
#include "atom_mapping/base/types.h"

namespace atom_map {

// An atom proposed in signed distance mode.
struct DistanceCandidate {
  Eigen::Vector3f center;
  float distance;          // m, from the surface point to the centre along its normal; negative behind the surface
  Eigen::Vector3f normal;  // unit, of the surface point: the gradient of the signed distance
};

struct DistanceCandidates {
  std::vector<DistanceCandidate> behind;   // step A
  std::vector<DistanceCandidate> infront;  // step C, the nearest to their surfaces first
  std::uint64_t proposed = 0;              // before interleaving

  std::size_t size() const { return behind.size() + infront.size(); }
};

// Steps A and C, to rays/normal_distance from the surface, with interleaving. `sensor` is the sensor's position, in the
// frame of the surface points. Other surfaces are not looked at: see dropCrossing.
DistanceCandidates traceNormals(const std::vector<SurfacePoint>& surface, const Eigen::Vector3f& sensor,
                                const MappingParameters& parameters, Random& random);

}  // namespace atom_map
