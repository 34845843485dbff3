#include "atom_mapping/planning/shortcut.h"

#include <cmath>

namespace atom_map {
namespace {

using Eigen::Vector3f;
using Clock = std::chrono::steady_clock;

constexpr int kPasses = 4;
constexpr double kGain = 1e-4;  // of a cost, less is not worth the points

// How many parts of at most `longest` a way has.
int partsOf(const Vector3f& from, const Vector3f& to, float longest) {
  return std::max(1, static_cast<int>(std::ceil((to - from).norm() / longest)));
}

Vector3f pointOn(const Vector3f& from, const Vector3f& to, int part, int parts) {
  return from + static_cast<float>(part) / static_cast<float>(parts) * (to - from);
}

bool isSafeWay(Clearance& clearance, const Vector3f& from, const Vector3f& to) {
  return clearance.isKnown(from, to) && clearance.isSafe(from, to);
}

// The straight way from a to b as points two radii apart or nearer, without a itself.
std::vector<Waypoint> straight(const Waypoint& a, const Waypoint& b, const PathTask& task) {
  std::vector<Waypoint> way;
  task.read([&](const AtomMap& map) {
    Clearance clearance(map, task.rules);
    const float reach = surfaceReach(task.preference, map.radius());
    const int parts = partsOf(a.position, b.position, 2.0F * map.radius());
    for (int i = 1; i < parts; ++i) {
      const Vector3f point = pointOn(a.position, b.position, i, parts);
      way.push_back({point, clearance.surfaceDistance(point, reach)});
    }
  });
  way.push_back(b);
  return way;
}

template <class Iterator>
double costOf(const Waypoint& start, Iterator begin, Iterator end, const PathPreference& preference) {
  double cost = 0.0;
  const Waypoint* last = &start;
  for (; begin != end; last = &*begin++) cost += wayCost(*last, *begin, preference);
  return cost;
}

std::vector<Waypoint> densified(const std::vector<Waypoint>& path, const PathTask& task) {
  std::vector<Waypoint> dense{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const std::vector<Waypoint> way = straight(path[i - 1], path[i], task);
    dense.insert(dense.end(), way.begin(), way.end());
  }
  return dense;
}

// Replaces what lies between two points of the path by the straight way, if that is better.
bool replace(std::vector<Waypoint>& path, std::size_t from, std::size_t to, const PathTask& task) {
  const auto begin = path.begin() + static_cast<std::ptrdiff_t>(from);
  const auto end = path.begin() + static_cast<std::ptrdiff_t>(to);
  const std::vector<Waypoint> way = straight(*begin, *end, task);
  const double old_cost = costOf(*begin, begin + 1, end + 1, task.preference);
  if (costOf(*begin, way.begin(), way.end(), task.preference) > (1.0 - kGain) * old_cost) return false;
  if (!passes(task, begin->position, end->position, isSafeWay)) return false;
  path.insert(path.erase(begin + 1, end + 1), way.begin(), way.end());
  return true;
}

}  // namespace

bool passes(const PathTask& task, const Vector3f& from, const Vector3f& to, const TestWay& test) {
  bool passes = true;
  int parts = 1;
  for (int i = 0; passes && i < parts; ++i) {
    task.read([&](const AtomMap& map) {
      parts = partsOf(from, to, 2.0F * map.radius());
      Clearance clearance(map, task.rules);
      passes =
          map.origin() == task.origin && test(clearance, pointOn(from, to, i, parts), pointOn(from, to, i + 1, parts));
    });
  }
  return passes;
}

std::vector<Waypoint> shortcut(std::vector<Waypoint> path, const PathTask& task, Clock::time_point deadline) {
  path = densified(path, task);
  for (int pass = 0; pass < kPasses; ++pass) {
    bool is_better = false;
    for (std::size_t from = 0; from + 2 < path.size(); ++from) {
      // From far to near, halving the gap.
      for (std::size_t gap = path.size() - 1 - from; gap >= 2; gap /= 2) {
        if (Clock::now() >= deadline) return path;
        if (!replace(path, from, from + gap, task)) continue;
        is_better = true;
        break;
      }
    }
    if (!is_better) break;
  }
  return path;
}

}  // namespace atom_map
