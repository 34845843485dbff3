#include "atom_mapping/query/collision.h"

#include <algorithm>
#include <array>
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
  const auto visit = [&](ConstAtomRef atom, float squared_distance) {
    if (found || classify(map, atom) != Occupancy::kOccupied) return;
    const float distance = std::sqrt(squared_distance);
    found = distance < radius + map.radius() ||
            classify(interpolate(map, pointTowards(center, atom.center(), radius))) == Occupancy::kOccupied;
  };
  map.atoms().forEachWithin(center, radius + 2.0F * map.radius(), visit, signsOfOccupied(map));
  return found;
}

// Remembers some of the atoms that it found, which often make the next point known as well.
class KnownSpace {
 public:
  explicit KnownSpace(const AtomMap& map) : map_(map), reach_(2.0F * map.radius()) {
    found_.fill(Vector3f::Constant(std::numeric_limits<float>::infinity()));
  }

  bool contains(const Vector3f& point) {
    const auto reaches = [&](const Vector3f& center) { return (center - point).squaredNorm() < reach_ * reach_; };
    if (std::any_of(found_.begin(), found_.end(), reaches)) return true;
    const auto found = map_.atoms().anyWithin(point, reach_);
    if (found) found_[next_++ % found_.size()] = *found;
    return found.has_value();
  }

 private:
  const AtomMap& map_;
  float reach_;
  std::array<Vector3f, 4> found_;
  std::size_t next_ = 0;
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
