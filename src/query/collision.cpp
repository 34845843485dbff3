#include "atom_mapping/query/collision.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr float kMaxSteps = 1000.0F;  // from center to rim; such a sphere leaves any map

// At a distance from `from`, on the way to another point.
Vector3f pointTowards(const Vector3f& from, const Vector3f& to, float distance) {
  return from + distance * (to - from).normalized();
}

bool reachesOccupied(const AtomMap& map, const Vector3f& center, float radius) {
  bool found = false;
  map.atoms().forEachWithin(center, radius + 2.0F * map.radius(), [&](ConstAtomRef atom, float squared_distance) {
    if (found || classify(map, atom) != Occupancy::kOccupied) return;
    const float distance = std::sqrt(squared_distance);
    found = distance < radius + map.radius() ||
            classify(interpolate(map, pointTowards(center, atom.center(), radius))) == Occupancy::kOccupied;
  });
  return found;
}

// Remembers the atom that it found last, which often makes the next point known as well.
class KnownSpace {
 public:
  explicit KnownSpace(const AtomMap& map) : map_(map), reach_(2.0F * map.radius()) {}

  bool contains(const Vector3f& point) {
    if ((last_ - point).squaredNorm() < reach_ * reach_) return true;
    const auto nearest = map_.atoms().nearest(point, reach_);
    if (nearest) last_ = nearest->center;
    return nearest.has_value();
  }

 private:
  const AtomMap& map_;
  float reach_;
  Vector3f last_ = Vector3f::Constant(std::numeric_limits<float>::infinity());
};

bool reachesUnknown(const AtomMap& map, const Vector3f& center, float radius) {
  KnownSpace known(map);
  const auto steps = static_cast<int>(std::min(std::ceil(radius / map.radius()), kMaxSteps));
  const float spacing = steps > 0 ? radius / static_cast<float>(steps) : 0.0F;
  for (int z = -steps; z <= steps; ++z) {
    for (int y = -steps; y <= steps; ++y) {
      for (int x = -steps; x <= steps; ++x) {
        if (x * x + y * y + z * z > steps * steps) continue;
        if (!known.contains(center + spacing * Eigen::Vector3i(x, y, z).cast<float>())) return true;
      }
    }
  }
  return false;
}

}  // namespace

bool collides(const AtomMap& map, const Vector3f& center, float radius, bool unknown_is_free) {
  return reachesOccupied(map, center, radius) || (!unknown_is_free && reachesUnknown(map, center, radius));
}

bool collides(const AtomMap& map, GaussianProcess& distances, const Vector3f& center, float radius,
              bool unknown_is_free) {
  assert(map.mode() == Mode::kSignedDistance);
  const auto estimate = distances.estimate(center);
  return (estimate && estimate->value < radius) || collides(map, center, radius, unknown_is_free);
}

}  // namespace atom_map
