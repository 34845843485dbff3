#include "atom_mapping/scan/normal_rays.h"

#include <algorithm>
#include <cmath>

#include "atom_mapping/base/angles.h"
#include "atom_mapping/scan/half_width.h"
#include "atom_mapping/scan/interleave.h"

namespace atom_map {
namespace {

// The distances from the sensor to the places along the normals, of all surface points at once.
class NormalRanges {
 public:
  NormalRanges(const std::vector<SurfacePoint>& surface, const Eigen::Vector3f& sensor) {
    squared_.reserve(surface.size());
    twice_along_.reserve(surface.size());
    for (const SurfacePoint& point : surface) {
      const Eigen::Vector3f offset = point.position - sensor;
      squared_.push_back(offset.squaredNorm());
      twice_along_.push_back(2.0F * offset.dot(point.normal));
    }
  }

  // Of the places so far in front of the points. A compiler makes it run four at a time.
  void at(float distance, std::vector<float>& ranges) const {
    ranges.resize(squared_.size());
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      const float squared = squared_[i] + distance * (twice_along_[i] + distance);
      ranges[i] = std::sqrt(std::max(0.0F, squared));
    }
  }

 private:
  std::vector<float> squared_;
  std::vector<float> twice_along_;  // of the offset from the sensor, along the normal
};

}  // namespace

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
  }
  candidates.proposed = surface.size();

  const NormalRanges normals(surface, sensor);
  std::vector<float> ranges;
  normals.at(0.0F, ranges);
  std::vector<float> rays_per_radian(surface.size());
  std::transform(ranges.begin(), ranges.end(), rays_per_radian.begin(),
                 [&](float range) { return 1.0F / std::max(resolution, spacing / range); });
  candidates.infront.reserve(2 * surface.size());
  for (float distance = radius; distance <= std::max(radius, reach); distance += 2.0F * radius) {  // step C
    normals.at(distance, ranges);
    candidates.proposed += surface.size();
    interleaver.keepEach(ranges, rays_per_radian, [&](std::uint32_t i) {
      const SurfacePoint& point = surface[i];
      candidates.infront.push_back({point.position + distance * point.normal, distance, point.normal});
    });
  }
  return candidates;
}

}  // namespace atom_map
