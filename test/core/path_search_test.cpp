#include "atom_mapping/planning/path_search.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "packed_map.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr float kRadius = 0.25F;
constexpr double kNone = std::numeric_limits<double>::infinity();

struct Problem {
  AtomMap map;
  Waypoint start;
  Waypoint goal;
  PathPreference preference;
  SafetyRules rules;
};

// Nothing when start or goal is no place for the robot.
std::optional<Problem> makeProblem(std::uint64_t seed, Mode mode, float surface_weight) {
  Random random(seed);
  Problem problem{makePackedMap(seed, mode, kRadius, 1.8F, 0.06F), {}, {}, {0.3F, 0.6F, surface_weight}, {}};
  SafetyRules& rules = problem.rules;
  rules.robot_radius = problem.preference.robot_radius;
  rules.margin = 0.05F;
  rules.start = drawWithin(random, 1.4F);
  rules.goal = drawWithin(random, 1.4F);
  Clearance clearance(problem.map, rules);
  if (!clearance.isSafe(rules.start) || !clearance.isSafe(rules.goal)) return std::nullopt;
  const float reach = surfaceReach(problem.preference, kRadius);
  problem.start = {rules.start, clearance.surfaceDistance(rules.start, reach)};
  problem.goal = {rules.goal, clearance.surfaceDistance(rules.goal, reach)};
  return problem;
}

// All places of the graph: start, goal, then the free atoms that are safe.
std::vector<Waypoint> placesOf(const Problem& problem) {
  std::vector<Waypoint> places{problem.start, problem.goal};
  Clearance clearance(problem.map, problem.rules);
  const float sign = problem.map.mode() == Mode::kOccupancy ? 1.0F : -1.0F;
  problem.map.atoms().forEach([&](ConstAtomRef atom) {
    if (sign * atom.value() >= 0.0F || !clearance.isSafe(atom.center())) return;
    places.push_back({atom.center(), clearance.surfaceDistance(atom, surfaceReach(problem.preference, kRadius))});
  });
  return places;
}

// Dijkstra's algorithm as its definition has it, over every pair of places.
double leastCost(const Problem& problem) {
  const std::vector<Waypoint> places = placesOf(problem);
  Clearance clearance(problem.map, problem.rules);
  std::vector<double> cost(places.size(), kNone);
  std::vector<bool> is_closed(places.size());
  cost[0] = 0.0;
  for (;;) {
    std::size_t nearest = places.size();
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!is_closed[i] && cost[i] < (nearest == places.size() ? kNone : cost[nearest])) nearest = i;
    }
    if (nearest == places.size() || nearest == 1) return cost[1];
    is_closed[nearest] = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Waypoint& a = places[nearest];
      const Waypoint& b = places[i];
      if (is_closed[i] || (a.position - b.position).squaredNorm() >= 16.0F * kRadius * kRadius) continue;
      const double next = cost[nearest] + wayCost(a, b, problem.preference);
      if (next >= cost[i] || !clearance.isKnown(a.position, b.position)) continue;
      if (clearance.isSafe(a.position, b.position)) cost[i] = next;
    }
  }
}

PathSearch makeSearch(const Problem& problem) {
  return {problem.start, problem.goal, kRadius, problem.preference, problem.rules};
}

void expectTheLeastCost(const Problem& problem, int& found, int& refused) {
  PathSearch search = makeSearch(problem);
  const auto state = search.advance(problem.map, std::chrono::steady_clock::time_point::max());
  const double expected = leastCost(problem);
  ASSERT_EQ(state == PathSearch::State::kFound, expected < kNone);
  if (expected == kNone) {
    ++refused;
    return;
  }
  ++found;
  EXPECT_NEAR(search.cost(), expected, 1e-6 * expected);
  const std::vector<Waypoint> path = search.path();
  EXPECT_EQ(path.front().position, problem.start.position);
  EXPECT_EQ(path.back().position, problem.goal.position);
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    cost += wayCost(path[i - 1], path[i], problem.preference);
    EXPECT_LT((path[i].position - path[i - 1].position).norm(), 4.0F * kRadius);
  }
  EXPECT_NEAR(cost, search.cost(), 1e-9);
}

TEST(PathSearch, FindsWhatDijkstraFinds) {
  for (const Mode mode : {Mode::kOccupancy, Mode::kSignedDistance}) {
    int found = 0;
    int refused = 0;
    for (std::uint64_t seed = 1; seed <= (mode == Mode::kOccupancy ? 150U : 30U); ++seed) {
      const auto problem = makeProblem(seed, mode, seed % 2 == 0 ? 0.0F : 3.0F);
      if (problem) expectTheLeastCost(*problem, found, refused);
    }
    EXPECT_GT(found, mode == Mode::kOccupancy ? 20 : 5);
    RecordProperty(mode == Mode::kOccupancy ? "found" : "found_by_distance", found);
    RecordProperty(mode == Mode::kOccupancy ? "refused" : "refused_by_distance", refused);
  }
}

TEST(PathSearch, InSlicesItFindsTheSame) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const auto problem = makeProblem(seed, Mode::kOccupancy, 0.0F);
    if (!problem) continue;
    PathSearch whole = makeSearch(*problem);
    PathSearch sliced = makeSearch(*problem);
    const auto state = whole.advance(problem->map, std::chrono::steady_clock::time_point::max());
    auto sliced_state = PathSearch::State::kSearching;
    while (sliced_state == PathSearch::State::kSearching) {
      sliced_state = sliced.advance(problem->map, std::chrono::steady_clock::time_point::min());
    }
    ASSERT_EQ(sliced_state, state);
    EXPECT_EQ(sliced.expanded(), whole.expanded());
    if (state != PathSearch::State::kFound) continue;
    ++found;
    EXPECT_EQ(sliced.cost(), whole.cost());
  }
  EXPECT_GT(found, 5);
}

TEST(PathSearch, AtomsMayVanishBetweenSlices) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    auto problem = makeProblem(seed, Mode::kOccupancy, 0.0F);
    if (!problem) continue;
    PathSearch search = makeSearch(*problem);
    for (int i = 0; i < 20; ++i) search.advance(problem->map, std::chrono::steady_clock::time_point::min());
    problem->map.clearRegion({Eigen::Vector3d::Constant(-9.0), Eigen::Vector3d(0.0, 9.0, 9.0)});
    EXPECT_NE(search.advance(problem->map, std::chrono::steady_clock::time_point::max()),
              PathSearch::State::kSearching);
  }
}

TEST(PathSearch, ItsCostIsTheLengthWithoutASurfaceTerm) {
  const Waypoint a{Vector3f::Zero(), 0.5F};
  const Waypoint b{Vector3f(0.0F, 3.0F, 4.0F), 2.5F};
  EXPECT_NEAR(wayCost(a, b, {0.3F, 1.0F, 0.0F}), 5.0, 1e-9);
  EXPECT_NEAR(wayCost(a, b, {0.3F, 1.0F, 2.0F}), 5.0 * (1.0 + 2.0 * 0.5 * (0.5 + 1.5)), 1e-6);  // | |sdf| - q |
  EXPECT_NEAR(wayCost({a.position, -0.5F}, b, {0.3F, 1.0F, 2.0F}), wayCost(a, b, {0.3F, 1.0F, 2.0F}), 1e-6);
}

}  // namespace
}  // namespace atom_map
