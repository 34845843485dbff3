#include "atom_mapping/planning/plan_path.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <utility>

#include "atom_mapping/planning/shortcut.h"
#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kSlice{1};               // of reading the map
constexpr std::array<float, 3> kMargins{0.75F, 0.4F, 0.0F};  // atomic radii, one tried after the other
constexpr double kDetour = 1.05;                             // what a margin may cost, over the cheapest path without
constexpr float kRounding = 1e-3F;                           // atomic radii, of a safe way's parts
constexpr float kBetween = 0.5F;  // atomic radii, from where distances were asked to a way's end

// What is fixed while one path is planned.
struct PathTask {
  ReadMap read;
  Eigen::Vector3d origin;  // map frame, of the frame that all positions are in
  PathPreference preference;
  SafetyRules rules;
  double max_cost = std::numeric_limits<double>::infinity();  // over atoms, of a path that is worth finding
  Mode mode = Mode::kOccupancy;                               // of the map, and its atoms' radius
  float radius = 0.0F;

  // An empty map may have taken over another's kind.
  bool isOf(const AtomMap& map) const { return map.origin() == origin && map.mode() == mode && map.radius() == radius; }
};

// Whether both ends will do; says in the answer why not.
bool examineEnds(const AtomMap& map, const PathRequest& request, const PathTask& task, PlannedPath& answer) {
  for (const bool is_start : {true, false}) {
    const Eigen::Vector3d& point = is_start ? request.start : request.goal;
    answer.outcome = examine(map, point, task.rules.robot_radius, task.rules.regression);
    if (answer.outcome == PathOutcome::kFound) continue;
    answer.is_start = is_start;
    const float reach = task.rules.robot_radius + map.radius();
    answer.room = static_cast<double>(Clearance(map, task.rules).surfaceDistance(map.toLocal(point), reach));
    return false;
  }
  return true;
}

PathSearch beginSearch(const AtomMap& map, const PathTask& task) {
  Clearance clearance(map, task.rules);
  const float reach = surfaceReach(task.preference, map.radius());
  return {makeWaypoint(task.rules.start, reach, clearance),
          makeWaypoint(task.rules.goal, reach, clearance),
          map.radius(),
          task.preference,
          task.rules,
          task.max_cost};
}

// Reads the map slice by slice until is_done(map, end of the slice); false when time is up or the map has become another.
template <class Advance>
bool advance(const PathTask& task, Clock::time_point deadline, const Advance& is_done) {
  bool done = false;
  bool is_lost = false;
  while (!done && !is_lost && Clock::now() < deadline) {
    task.read([&](const AtomMap& map) {
      is_lost = !task.isOf(map);
      done = !is_lost && is_done(map, std::min(deadline, Clock::now() + kSlice));
    });
  }
  return done;
}

bool stillHolds(const PlannedPath& path, const PathTask& task) {
  bool holds = true;
  task.read([&](const AtomMap& map) {
    SafetyRules rules = task.rules;
    rules.robot_radius -= kRounding * map.radius();
    const float least = rules.robot_radius - kBetween * map.radius();  // m, to surfaces
    Clearance clearance(map, rules);
    for (std::size_t i = 1; holds && i < path.points.size(); ++i) {
      const Eigen::Vector3f from = map.toLocal(path.points[i - 1]);
      const Eigen::Vector3f to = map.toLocal(path.points[i]);
      holds = clearance.isKnown(from, to) && clearance.isClear(from, to) && clearance.keepsDistance(to, least);
    }
  });
  return holds;
}

void fill(PlannedPath& answer, const std::vector<Waypoint>& path, const PathTask& task) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    answer.points.emplace_back(path[i].position.cast<double>() + task.origin);
    if (i == 0) continue;
    answer.length += (path[i].position - path[i - 1].position).cast<double>().norm();
    answer.cost += wayCost(path[i - 1], path[i], task.preference);
  }
}

std::vector<Waypoint> shortened(std::vector<Waypoint> path, const PathTask& task, Clock::time_point deadline) {
  Shortcut shortcut(std::move(path), task.preference, task.rules);
  advance(task, deadline, [&](const AtomMap& map, Clock::time_point end) { return shortcut.advance(map, end); });
  return shortcut.path();
}

void withdraw(PlannedPath& answer) {
  answer.outcome = PathOutcome::kTimeout;
  answer.points.clear();
  answer.length = answer.cost = 0.0;
}

// Plans with one margin, in atomic radii.
PlannedPath plan(const PathRequest& request, PathTask& task, float margin, Clock::time_point deadline) {
  PlannedPath answer;
  answer.nearest = request.start;
  std::vector<PathSearch> search;  // one, unless an end will not do
  task.read([&](const AtomMap& map) {
    task.origin = map.origin();
    task.mode = map.mode();
    task.radius = map.radius();
    task.rules.margin = margin * map.radius();
    task.rules.start = map.toLocal(request.start);
    task.rules.goal = map.toLocal(request.goal);
    if (examineEnds(map, request, task, answer)) search.push_back(beginSearch(map, task));
  });
  if (search.empty()) return answer;

  auto state = PathSearch::State::kSearching;
  const bool is_done = advance(task, deadline, [&](const AtomMap& map, Clock::time_point end) {
    state = search.front().advance(map, end);
    return state != PathSearch::State::kSearching;
  });
  answer.expanded = search.front().expanded();
  answer.nearest = search.front().nearest().cast<double>() + task.origin;
  answer.outcome = is_done ? PathOutcome::kNoConnection : PathOutcome::kTimeout;
  if (state != PathSearch::State::kFound) return answer;
  std::vector<Waypoint> path = search.front().path();
  if (request.shortcut) path = shortened(std::move(path), task, deadline);
  fill(answer, path, task);
  answer.outcome = PathOutcome::kFound;
  task.max_cost = search.front().cost() / kDetour;
  return answer;
}

// Whether it is worth trying a lesser margin than that of the answer.
bool mayGain(const PlannedPath& answer, float margin, const PathRequest& request) {
  if (answer.outcome != PathOutcome::kFound) return answer.outcome == PathOutcome::kNoConnection;
  return margin == kMargins.front() && answer.cost > kDetour * (request.goal - request.start).norm();
}

// Plans with one margin after the other.
PlannedPath planOnce(const PathRequest& request, PathTask& task, Clock::time_point deadline) {
  PlannedPath answer;
  std::uint32_t expanded = 0;
  task.max_cost = std::numeric_limits<double>::infinity();
  for (const float margin : kMargins) {
    PlannedPath planned = plan(request, task, margin, deadline);
    expanded += planned.expanded;
    if (planned.outcome == PathOutcome::kFound || answer.outcome != PathOutcome::kFound) answer = std::move(planned);
    if (!mayGain(answer, margin, request)) break;
  }
  answer.expanded = expanded;
  return answer;
}

}  // namespace

PathOutcome examine(const AtomMap& map, const Eigen::Vector3d& point, float robot_radius,
                    const GaussianProcessParameters& regression) {
  const Eigen::Vector3f local = map.toLocal(point);
  const Occupancy occupancy = classify(interpolate(map, local));
  if (occupancy == Occupancy::kUnknown) return PathOutcome::kUnknown;
  if (occupancy == Occupancy::kOccupied) return PathOutcome::kOccupied;
  const bool is_safe = Clearance(map, {regression, robot_radius, 0.0F, local, local}).isSafe(local);
  return is_safe ? PathOutcome::kFound : PathOutcome::kTooTight;
}

PlannedPath planPath(const ReadMap& read, const PathRequest& request, const GaussianProcessParameters& regression) {
  const Clock::time_point begin = Clock::now();
  const Clock::time_point deadline =
      begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(request.timeout));
  PathTask task{read, Eigen::Vector3d::Zero(), request.preference, {regression, request.preference.robot_radius}};
  PlannedPath answer;
  std::uint32_t expanded = 0;
  do {
    answer = planOnce(request, task, deadline);
    expanded += answer.expanded;
    if (answer.outcome == PathOutcome::kFound && !stillHolds(answer, task)) withdraw(answer);
  } while (answer.outcome == PathOutcome::kTimeout && Clock::now() < deadline);
  answer.expanded = expanded;
  answer.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return answer;
}

}  // namespace atom_map
