#include "atom_mapping/planning/path_search.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

constexpr float kReach = 4.0F;          // atomic radii, between connected atoms (paper IV-A)
constexpr float kSurfaceReach = 16.0F;  // atomic radii

}  // namespace

float surfaceReach(const PathPreference& preference, float radius) {
  return preference.surface_weight > 0.0F ? preference.surface_distance + kSurfaceReach * radius : 0.0F;
}

Waypoint makeWaypoint(const Eigen::Vector3f& point, float reach, Clearance& clearance) {
  return {point, reach > 0.0F ? clearance.surfaceDistance(point, reach) : 0.0F};
}

double wayCost(const Waypoint& a, const Waypoint& b, const PathPreference& preference) {
  const double length = (b.position - a.position).cast<double>().norm();
  const auto deviation = [&](const Waypoint& at) {
    return static_cast<double>(std::abs(std::abs(at.surface_distance) - preference.surface_distance));
  };
  return length * (1.0 + 0.5 * static_cast<double>(preference.surface_weight) * (deviation(a) + deviation(b)));
}

PathSearch::PathSearch(const Waypoint& start, const Waypoint& goal, float radius, const PathPreference& preference,
                       const SafetyRules& rules, double max_cost)
    : radius_(radius),
      preference_(preference),
      rules_(rules),
      reach_(surfaceReach(preference, radius)),
      max_cost_(max_cost) {
  nodes_ = {{start, true}, {goal, true}};
  propose(kStart, kStart);
}

PathSearch::State PathSearch::advance(const AtomMap& map, std::chrono::steady_clock::time_point deadline) {
  Clearance clearance(map, rules_);
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end(), std::greater<>());
    const Way way = open_.back();
    open_.pop_back();
    if (accept(way, clearance)) {
      if (way.node == kGoal) return State::kFound;
      expand(way.node, map, clearance);
    }
    if (std::chrono::steady_clock::now() >= deadline) return State::kSearching;
  }
  return State::kExhausted;
}

// Closes the node if it is open and the way to it is safe.
bool PathSearch::accept(const Way& way, Clearance& clearance) {
  Record& node = nodes_[way.node];
  if (node.is_closed || !isSafeWay(way.parent, way.node, clearance)) return false;
  node.is_closed = true;
  node.parent = way.parent;
  node.cost = way.cost;
  return true;
}

void PathSearch::expand(Node node, const AtomMap& map, Clearance& clearance) {
  ++expanded_;
  const Eigen::Vector3f center = nodes_[node].at.position;
  const Eigen::Vector3f goal = nodes_[kGoal].at.position;
  if ((center - goal).squaredNorm() < (nearest() - goal).squaredNorm()) nearest_ = node;
  if ((center - goal).norm() < kReach * radius_) propose(node, kGoal);
  map.atoms().forEachWithin(center, kReach * radius_, [&](ConstAtomRef atom, float /*squared_distance*/) {
    if (classify(map, atom) != Occupancy::kFree) return;
    const Node neighbor = find(atom, clearance);
    if (nodes_[neighbor].is_safe && !nodes_[neighbor].is_closed) propose(node, neighbor);
  });
}

// The atom's node; its surroundings are looked at when it is first met.
PathSearch::Node PathSearch::find(ConstAtomRef atom, Clearance& clearance) {
  const Eigen::Vector3f center = atom.center();
  const auto [found, is_new] = atoms_.try_emplace(center, static_cast<Node>(nodes_.size()));
  if (is_new) {
    const bool is_safe = clearance.isSafe(center);
    nodes_.push_back({{center, is_safe ? clearance.surfaceDistance(atom, reach_) : 0.0F}, is_safe});
  }
  return found->second;
}

void PathSearch::propose(Node from, Node to) {
  const Waypoint& b = nodes_[to].at;
  const double cost = nodes_[from].cost + wayCost(nodes_[from].at, b, preference_);
  // Eq. (12): the cost so far, the surface term within it, and the straight way to the goal.
  const auto left = static_cast<double>((nodes_[kGoal].at.position - b.position).norm());
  if (cost + left > max_cost_) return;
  open_.push_back({cost + left, cost, to, from});
  std::push_heap(open_.begin(), open_.end(), std::greater<>());
}

bool PathSearch::isSafeWay(Node from, Node to, Clearance& clearance) const {
  const Eigen::Vector3f& a = nodes_[from].at.position;
  const Eigen::Vector3f& b = nodes_[to].at.position;
  const bool joins_atoms = from != kStart && to != kGoal;
  return (joins_atoms || clearance.isKnown(a, b)) && clearance.isSafe(a, b);
}

std::vector<Waypoint> PathSearch::path() const {
  std::vector<Waypoint> path{nodes_[kGoal].at};
  for (Node node = kGoal; node != kStart;) {
    node = nodes_[node].parent;
    path.push_back(nodes_[node].at);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace atom_map
