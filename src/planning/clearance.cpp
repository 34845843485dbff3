#include "atom_mapping/planning/clearance.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "atom_mapping/query/collision.h"
#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr float kStep = 0.5F;  // atomic radii

// A straight way, and the point of it nearest to another.
struct Way {
  Way(const Vector3f& from, const Vector3f& to)
      : start(from),
        length((to - from).norm()),
        direction(length > 0.0F ? Vector3f((to - from) / length) : Vector3f::UnitX()) {}

  Vector3f at(float along) const { return start + along * direction; }
  float nearestTo(const Vector3f& point) const { return std::clamp(direction.dot(point - start), 0.0F, length); }

  Vector3f start;
  float length;
  Vector3f direction;  // unit
};

}  // namespace

Clearance::Clearance(const AtomMap& map, const SafetyRules& rules)
    : map_(map), rules_(rules), distances_(map, rules.regression) {}

// To the nearest occupied atom's center, looking farther and farther.
float Clearance::occupiedDistance(const Vector3f& point, float reach) const {
  float searched = std::min(4.0F * map_.radius(), reach);
  for (;; searched = std::min(2.0F * searched, reach)) {
    float nearest = searched * searched;
    map_.atoms().forEachWithin(point, searched, [&](ConstAtomRef atom, float squared_distance) {
      if (squared_distance < nearest && classify(map_, atom) == Occupancy::kOccupied) nearest = squared_distance;
    });
    if (nearest < searched * searched || searched == reach) return std::sqrt(nearest);
  }
}

float Clearance::surfaceDistance(const Vector3f& point, float reach) {
  const float occupied = occupiedDistance(point, reach + map_.radius()) - map_.radius();
  if (map_.mode() == Mode::kOccupancy) return occupied;
  const auto estimate = distances_.estimate(point);
  return estimate ? std::min(occupied, estimate->value) : occupied;
}

float Clearance::surfaceDistance(ConstAtomRef atom, float reach) const {
  const float occupied = occupiedDistance(atom.center(), reach + map_.radius()) - map_.radius();
  return map_.mode() == Mode::kOccupancy ? occupied : std::min(occupied, atom.value());
}

bool Clearance::isSafe(const Vector3f& from, const Vector3f& to) {
  if (!isClear(from, to)) return false;
  const Way way(from, to);
  const float steps = std::max(1.0F, std::ceil(way.length / (kStep * map_.radius())));
  for (float i = 0.0F; i <= steps; i += 1.0F) {
    const Vector3f point = way.at(i / steps * way.length);
    if (!keepsDistance(point, rules_.robot_radius) || collidesAt(point)) return false;
  }
  return true;
}

bool Clearance::isClear(const Vector3f& from, const Vector3f& to) const {
  const Way way(from, to);
  const float reach = rules_.robot_radius + map_.radius();
  bool is_clear = true;
  map_.atoms().forEachWithin(0.5F * (from + to), 0.5F * way.length + reach, [&](ConstAtomRef atom, float) {
    if (!is_clear || classify(map_, atom) != Occupancy::kOccupied) return;
    const Vector3f center = atom.center();
    is_clear = (center - way.at(way.nearestTo(center))).squaredNorm() >= reach * reach;
  });
  return is_clear;
}

bool Clearance::collidesAt(const Vector3f& point) const {
  const float core = 2.0F * map_.radius();
  const float to_end = std::min((point - rules_.start).squaredNorm(), (point - rules_.goal).squaredNorm());
  if (to_end < core * core) return false;
  const float radius = rules_.robot_radius + rules_.margin;
  return collides(map_, point, std::min(radius, core), false) || (radius > core && collides(map_, point, radius, true));
}

bool Clearance::keepsDistance(const Vector3f& point, float least) {
  if (map_.mode() == Mode::kOccupancy) return true;
  const auto estimate = distances_.estimate(point);
  return !estimate || estimate->value >= least;
}

bool Clearance::isKnown(const Vector3f& from, const Vector3f& to) const {
  const Way way(from, to);
  const float reach = 2.0F * map_.radius();
  std::vector<std::pair<float, float>> known;  // from where to where along the way, one an atom
  map_.atoms().forEachWithin(0.5F * (from + to), 0.5F * way.length + reach, [&](ConstAtomRef atom, float) {
    const float along = way.direction.dot(atom.center() - from);
    const float squared_height = (atom.center() - way.at(along)).squaredNorm();
    if (squared_height >= reach * reach) return;
    const float half_chord = std::sqrt(reach * reach - squared_height);
    known.emplace_back(along - half_chord, along + half_chord);
  });
  std::sort(known.begin(), known.end());
  float end = 0.0F;
  for (const auto& [enter, leave] : known) {
    if (enter > end) return false;
    end = std::max(end, leave);
  }
  return !known.empty() && end >= way.length;
}

}  // namespace atom_map
