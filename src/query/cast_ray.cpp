#include "atom_mapping/query/cast_ray.h"

#include <algorithm>
#include <cassert>

#include "atom_mapping/query/free_way.h"
#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

constexpr double kStep = 0.25;  // atomic radii
constexpr double kTolerance = 0.01;

// `ask` gives the occupancy at a point.
template <class Ask>
CastRay follow(const AtomMap& map, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, double range,
               const Ask& ask) {
  const auto at = [&](double distance) { return ask(origin + static_cast<float>(distance) * direction); };
  const double step = kStep * static_cast<double>(map.radius());
  const double tolerance = kTolerance * static_cast<double>(map.radius());
  FreeWay way(map, origin, direction);
  double free = way.end(0.0, range);  // the farthest free point so far
  double end = free;
  Occupancy met = free > 0.0 ? Occupancy::kFree : at(0.0);
  while (met == Occupancy::kFree && free < range) {
    end = std::min(free + step, range);
    met = at(end);
    if (met == Occupancy::kFree) free = way.end(end, range);
  }
  if (met == Occupancy::kFree) return {RayEnd::kMiss, static_cast<float>(range)};
  while (end - free > tolerance) {
    const double middle = 0.5 * (free + end);
    const Occupancy there = at(middle);
    if (there == Occupancy::kFree) {
      free = middle;
    } else {
      end = middle;
      met = there;
    }
  }
  return {met == Occupancy::kOccupied ? RayEnd::kHit : RayEnd::kUnknown, static_cast<float>(end)};
}

}  // namespace

CastRay castRay(const AtomMap& map, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float max_range) {
  assert(map.mode() == Mode::kOccupancy);
  return follow(map, origin, direction, max_range,
                [&](const Eigen::Vector3f& point) { return classify(interpolate(map, point)); });
}

CastRay castRay(const AtomMap& map, GaussianProcess& distances, const Eigen::Vector3f& origin,
                const Eigen::Vector3f& direction, float max_range) {
  assert(map.mode() == Mode::kSignedDistance);
  return follow(map, origin, direction, max_range, [&](const Eigen::Vector3f& point) {
    const auto estimate = distances.estimate(point);
    return classify(estimate ? std::make_optional(-estimate->value) : std::nullopt);
  });
}

}  // namespace atom_map
