#include "atom_mapping/scan/normal_rays.h"

#include <algorithm>

#include "atom_mapping/base/angles.h"
#include "atom_mapping/scan/half_width.h"
#include "atom_mapping/scan/interleave.h"

namespace atom_map {

DistanceCandidates traceNormals(const std::vector<SurfacePoint>& surface, const Eigen::Vector3f& sensor,
                                const MappingParameters& parameters, Random& random) {
  const auto radius = static_cast<float>(parameters.radius);
  const auto reach = static_cast<float>(parameters.rays.normal_distance);
  const auto resolution = static_cast<float>(parameters.scan.horizontal_resolution * kDegree);
  const auto spacing = static_cast<float>(parameters.scan.thinning * parameters.radius);
  const auto farthest = static_cast<float>(parameters.scan.max_range) + reach;
  Interleaver interleaver(radius, static_cast<float>(parameters.rays.lambda), farthest, random);

  DistanceCandidates candidates;
  candidates.behind.reserve(surface.size());
  for (const SurfacePoint& point : surface) {  // step A
    const float depth = depthBehind(point, radius);
    candidates.behind.push_back({point.position - depth * point.normal, -depth, point.normal});
    ++candidates.proposed;
  }
  for (float distance = radius; distance <= std::max(radius, reach); distance += 2.0F * radius) {  // step C
    for (const SurfacePoint& point : surface) {
      const Eigen::Vector3f center = point.position + distance * point.normal;
      const float range = (point.position - sensor).norm();
      ++candidates.proposed;
      if (!interleaver.keep((center - sensor).norm(), std::max(resolution, spacing / range))) continue;
      candidates.infront.push_back({center, distance, point.normal});
    }
  }
  return candidates;
}

}  // namespace atom_map
