#include "atom_mapping/query/cast_ray.h"

#include <algorithm>

#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

constexpr double kStep = 0.5;  // atomic radii
constexpr double kTolerance = 0.01;

}  // namespace

CastRay castRay(const AtomMap& map, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float max_range) {
  const auto ask = [&](double distance) {
    return classify(interpolate(map, origin + static_cast<float>(distance) * direction));
  };
  const double step = kStep * static_cast<double>(map.radius());
  const double tolerance = kTolerance * static_cast<double>(map.radius());
  const double range = max_range;
  double free = 0.0;  // the farthest free point so far
  double end = 0.0;
  Occupancy met = ask(end);
  for (double i = 1.0; met == Occupancy::kFree && end < range; i += 1.0) {
    free = end;
    end = std::min(i * step, range);
    met = ask(end);
  }
  if (met == Occupancy::kFree) return {RayEnd::kMiss, max_range};
  while (end - free > tolerance) {
    const double middle = 0.5 * (free + end);
    const Occupancy there = ask(middle);
    if (there == Occupancy::kFree) {
      free = middle;
    } else {
      end = middle;
      met = there;
    }
  }
  return {met == Occupancy::kOccupied ? RayEnd::kHit : RayEnd::kUnknown, static_cast<float>(end)};
}

}  // namespace atom_map
