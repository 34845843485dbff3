#include "atom_mapping/scan/rays.h"

#include <algorithm>
#include <cmath>

#include "atom_mapping/base/angles.h"
#include "atom_mapping/scan/half_width.h"
#include "atom_mapping/scan/interleave.h"

namespace atom_map {
namespace {

float logOdds(double probability) {
  return static_cast<float>(std::log(probability / (1.0 - probability)));
}

class RayTracer {
 public:
  RayTracer(const Eigen::Vector3f& sensor, const MappingParameters& parameters, Random& random)
      : sensor_(sensor),
        radius_(static_cast<float>(parameters.radius)),
        min_facing_(static_cast<float>(std::cos(parameters.rays.max_incidence * kDegree))),
        hit_(logOdds(parameters.occupancy.hit_probability)),
        miss_(logOdds(parameters.occupancy.miss_probability)),
        thin_weight_(static_cast<float>(parameters.occupancy.thin_weight)),
        hold_reach_(static_cast<float>(parameters.occupancy.hold_reach) * radius_),
        horizontal_resolution_(static_cast<float>(parameters.scan.horizontal_resolution * kDegree)),
        spacing_(static_cast<float>(parameters.scan.thinning * parameters.radius)),
        interleaver_(radius_, static_cast<float>(parameters.rays.lambda), static_cast<float>(parameters.scan.max_range),
                     random) {}

  // Step A: one occupied atom behind the surface and tangent to it.
  // Choice: none is dropped by interleaving, which is for the crowd near the sensor: thin things would vanish.
  // Choice: the returns of thin things weigh more: most rays nearby pass them by.
  void traceBehind(const SurfacePoint& point, Candidates& candidates) const {
    const bool thin = std::isfinite(point.half_width);
    candidates.occupied.push_back({point.position - depthBehind(point, radius_) * point.normal,
                                   thin ? thin_weight_ * hit_ : hit_, hold_reach_,
                                   thin ? Aside::kOfAll : Aside::kNever});
    ++candidates.proposed;
  }

  // Step B: free atoms from the surface to the sensor, the first tangent to the surface (and to the atom of step A).
  void traceToSensor(const SurfacePoint& point, Candidates& candidates) {
    const Eigen::Vector3f ray = sensor_ - point.position;
    const float range = ray.norm();
    const Eigen::Vector3f direction = ray / range;
    const float facing = std::max(point.normal.dot(direction), min_facing_);
    // Choice: the resolution in Eq. (1) is that of the rays which the filter left over.
    const float resolution = std::max(horizontal_resolution_, spacing_ / range);
    traceFree(point.position, direction, (2.0F * radius_ - depthBehind(point, radius_)) / facing, range, resolution,
              candidates);
  }

  // All the way from max_range (m) to the sensor: nothing is known to end the ray.
  void traceNoReturn(const Eigen::Vector3f& direction, float max_range, Candidates& candidates) {
    traceFree(sensor_ + max_range * direction, -direction, radius_, max_range, horizontal_resolution_, candidates);
  }

 private:
  void traceFree(const Eigen::Vector3f& start, const Eigen::Vector3f& direction, float first, float range,
                 float resolution, Candidates& candidates) {
    const float step = 2.0F * radius_;
    const auto count = static_cast<std::uint32_t>(std::max(0.0F, std::ceil((range - first) / step)));
    candidates.proposed += count;
    interleaver_.keepAlong(range - first, count, resolution, [&](std::uint32_t i) {
      const float along = first + static_cast<float>(i) * step;
      candidates.free.push_back({start + along * direction, miss_, 0.0F, Aside::kOfOne});
    });
  }

  Eigen::Vector3f sensor_;
  float radius_;
  float min_facing_;
  float hit_;
  float miss_;
  float thin_weight_;
  float hold_reach_;  // m
  float horizontal_resolution_;
  float spacing_;
  Interleaver interleaver_;
};

}  // namespace

Candidates traceRays(const std::vector<SurfacePoint>& surface, const std::vector<Eigen::Vector3f>& no_returns,
                     const Eigen::Vector3f& sensor, const MappingParameters& parameters, Random& random) {
  RayTracer tracer(sensor, parameters, random);
  Candidates candidates;
  candidates.occupied.reserve(surface.size());
  candidates.free.reserve(4 * surface.size());
  for (const SurfacePoint& point : surface) {
    tracer.traceBehind(point, candidates);
    tracer.traceToSensor(point, candidates);
  }
  for (const Eigen::Vector3f& direction : no_returns) {
    tracer.traceNoReturn(direction, static_cast<float>(parameters.scan.max_range), candidates);
  }
  return candidates;
}

}  // namespace atom_map
