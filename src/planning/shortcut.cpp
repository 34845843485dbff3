#include "atom_mapping/planning/shortcut.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr int kPasses = 4;
constexpr int kSweeps = 20;
constexpr std::size_t kLongest = 256;  // points that a straight way may replace at once: some milliseconds
constexpr double kGain = 1e-4;         // of a cost; less is not worth the points

// The straight way from a to b as points two radii apart or nearer, without a itself.
std::vector<Waypoint> straight(const Waypoint& a, const Waypoint& b, const AtomMap& map, Clearance& clearance,
                               const PathPreference& preference) {
  const float reach = surfaceReach(preference, map.radius());
  const Vector3f way = b.position - a.position;
  const float parts = std::max(1.0F, std::ceil(way.norm() / (2.0F * map.radius())));
  std::vector<Waypoint> points;
  for (float i = 1.0F; i < parts; i += 1.0F) {
    points.push_back(makeWaypoint(a.position + i / parts * way, reach, clearance));
  }
  points.push_back(b);
  return points;
}

bool isSafeWay(const Waypoint& start, const std::vector<Waypoint>& points, Clearance& clearance) {
  const Waypoint* last = &start;
  for (const Waypoint& point : points) {
    if (!clearance.isKnown(last->position, point.position)) return false;
    if (!clearance.isSafe(last->position, point.position)) return false;
    last = &point;
  }
  return true;
}

template <class Iterator>
double costOf(const Waypoint& start, Iterator begin, Iterator end, const PathPreference& preference) {
  double cost = 0.0;
  const Waypoint* last = &start;
  for (; begin != end; last = &*begin++) cost += wayCost(*last, *begin, preference);
  return cost;
}

std::vector<Waypoint> densified(const std::vector<Waypoint>& path, const AtomMap& map, Clearance& clearance,
                                const PathPreference& preference) {
  std::vector<Waypoint> dense{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const std::vector<Waypoint> way = straight(path[i - 1], path[i], map, clearance, preference);
    dense.insert(dense.end(), way.begin(), way.end());
  }
  return dense;
}

}  // namespace

Shortcut::Shortcut(std::vector<Waypoint> path, const PathPreference& preference, const SafetyRules& rules)
    : path_(std::move(path)), preference_(preference), rules_(rules) {}

std::size_t Shortcut::longestFrom(std::size_t i) const {
  return std::min(path_.size() - 1 - i, kLongest);
}

// From each point on: to the last one, or as far as may be, then half as far, and so on.
bool Shortcut::advance(const AtomMap& map, std::chrono::steady_clock::time_point deadline) {
  if (!is_dense_) {
    Clearance clearance(map, rules_);
    path_ = densified(path_, map, clearance, preference_);
    is_dense_ = true;
    gap_ = longestFrom(0);
  }
  while (passes_ < kPasses) {
    goOn(gap_ >= 2 && replace(map, from_, from_ + gap_));
    if (std::chrono::steady_clock::now() >= deadline) return false;
  }
  while (sweeps_ < kSweeps) {
    tightenNext(map);
    if (std::chrono::steady_clock::now() >= deadline) return sweeps_ >= kSweeps;
  }
  return true;
}

// Sweep by sweep over the points between the ends, until one gains nothing.
void Shortcut::tightenNext(const AtomMap& map) {
  if (from_ + 2 < path_.size()) {
    gains_ = tighten(map, ++from_) || gains_;
    return;
  }
  sweeps_ = gains_ ? sweeps_ + 1 : kSweeps;
  gains_ = false;
  from_ = 0;
}

// Moves a point towards the middle of those beside it, as far as that is safe, if the path costs less by it.
bool Shortcut::tighten(const AtomMap& map, std::size_t i) {
  Clearance clearance(map, rules_);
  const Waypoint& before = path_[i - 1];
  const Waypoint& after = path_[i + 1];
  const double old_cost = wayCost(before, path_[i], preference_) + wayCost(path_[i], after, preference_);
  const Vector3f way = 0.5F * (before.position + after.position) - path_[i].position;
  for (const float share : {1.0F, 0.5F, 0.25F}) {
    const float reach = surfaceReach(preference_, map.radius());
    const Waypoint moved = makeWaypoint(path_[i].position + share * way, reach, clearance);
    const double cost = wayCost(before, moved, preference_) + wayCost(moved, after, preference_);
    if (cost > (1.0 - kGain) * old_cost || !isSafeWay(before, {moved, after}, clearance)) continue;
    path_[i] = moved;
    return true;
  }
  return false;
}

void Shortcut::goOn(bool is_replaced) {
  gains_ = gains_ || is_replaced;
  gap_ /= 2;
  if (!is_replaced && gap_ >= 2) return;
  ++from_;
  if (from_ + 2 >= path_.size()) {
    passes_ = gains_ ? passes_ + 1 : kPasses;
    gains_ = false;
    from_ = 0;
  }
  gap_ = longestFrom(from_);
}

// Puts the straight way between two points in the place of what lies between them, if that is better.
bool Shortcut::replace(const AtomMap& map, std::size_t from, std::size_t to) {
  Clearance clearance(map, rules_);
  const auto begin = path_.begin() + static_cast<std::ptrdiff_t>(from);
  const auto end = path_.begin() + static_cast<std::ptrdiff_t>(to);
  const std::vector<Waypoint> way = straight(*begin, *end, map, clearance, preference_);
  const double old_cost = costOf(*begin, begin + 1, end + 1, preference_);
  if (costOf(*begin, way.begin(), way.end(), preference_) > (1.0 - kGain) * old_cost) return false;
  if (!isSafeWay(*begin, way, clearance)) return false;
  path_.insert(path_.erase(begin + 1, end + 1), way.begin(), way.end());
  return true;
}

}  // namespace atom_map
