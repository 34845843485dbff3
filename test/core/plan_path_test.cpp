#include "atom_mapping/planning/plan_path.h"

#include <gtest/gtest.h>

#include "atom_mapping/query/collision.h"
#include "packed_map.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

constexpr float kRadius = 0.25F;

ReadMap reading(const AtomMap& map) {
  return [&map](const std::function<void(const AtomMap&)>& use) { use(map); };
}

PlannedPath plan(const AtomMap& map, const PathRequest& request) {
  return planPath(reading(map), request, GaussianProcessParameters());
}

// Free atoms on a lattice in a box of 6 x 4 x 4 m about the origin, with an occupied wall at x = 0 but for a gate.
AtomMap makeGate(float gate_half) {
  AtomMap map(Mode::kOccupancy, kRadius);
  const float free = -2.0F;
  const float occupied = 2.0F;
  for (int x = -6; x <= 6; ++x) {
    for (int y = -4; y <= 4; ++y) {
      for (int z = -4; z <= 4; ++z) {
        const Eigen::Vector3f center = 0.5F * Eigen::Vector3f(x, y, z);
        const bool is_wall = x == 0 && std::max(std::abs(center.y()), std::abs(center.z())) > gate_half;
        map.atoms().insert(center, is_wall ? &occupied : &free);
      }
    }
  }
  return map;
}

PathRequest throughTheGate(float robot_radius) {
  return {Vector3d(-2.1, 0.2, 0.1), Vector3d(2.2, 0.1, -0.2), {robot_radius, 1.0F, 0.0F}, 5.0, true};
}

// All along the path, every 2 cm: by force against every atom, and by collides() away from its ends.
void expectSafe(const AtomMap& map, const PlannedPath& path, float robot_radius) {
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Vector3d way = path.points[i] - path.points[i - 1];
    const int steps = static_cast<int>(way.norm() / 0.02) + 1;
    for (int k = 0; k <= steps; ++k) {
      const Vector3d point = path.points[i - 1] + static_cast<double>(k) / steps * way;
      double nearest = 1e9;
      double nearest_occupied = 1e9;
      map.atoms().forEach([&](ConstAtomRef atom) {
        const double distance = (map.toMap(atom.center()) - point).norm();
        const bool is_occupied = (map.mode() == Mode::kOccupancy ? atom.value() : -atom.value()) >= 0.0F;
        nearest = std::min(nearest, distance);
        if (is_occupied) nearest_occupied = std::min(nearest_occupied, distance);
      });
      ASSERT_LT(nearest, 2.0F * kRadius + 1e-4F);
      ASSERT_GE(nearest_occupied, robot_radius + kRadius - 1e-3F);
    }
  }
}

TEST(PlanPath, KeepsTheRobotsRadiusAllAlong) {
  for (const Mode mode : {Mode::kOccupancy, Mode::kSignedDistance}) {
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      Random random(seed);
      const AtomMap map = makePackedMap(seed, mode, kRadius, 2.2F, 0.03F);
      const float robot_radius = draw(random, 0.05F, 0.5F);
      PathRequest request{drawWithin(random, 1.8F).cast<double>(), drawWithin(random, 1.8F).cast<double>(), {}};
      request.preference = {robot_radius, 0.5F, seed % 2 == 0 ? 0.0F : 2.0F};
      request.shortcut = seed % 3 != 0;
      const PlannedPath path = plan(map, request);
      if (path.outcome != PathOutcome::kFound) continue;
      ++found;
      EXPECT_LT((path.points.front() - request.start).norm() + (path.points.back() - request.goal).norm(), 1e-5);
      EXPECT_GE(path.cost, path.length * (1.0 - 1e-6));
      expectSafe(map, path, robot_radius);
    }
    EXPECT_GT(found, 10);
  }
}

TEST(PlanPath, AwayFromItsEndsNoSphereCollides) {
  int asked = 0;
  for (const float gate_half : {1.1F, 1.6F}) {
    const AtomMap map = makeGate(gate_half);
    const PlannedPath path = plan(map, throughTheGate(0.3F));
    ASSERT_EQ(path.outcome, PathOutcome::kFound);
    for (const Vector3d& point : path.points) {
      if (std::min((point - path.points.front()).norm(), (point - path.points.back()).norm()) < 0.5) continue;
      ++asked;
      EXPECT_FALSE(collides(map, map.toLocal(point), 0.3F, false));
    }
  }
  EXPECT_GT(asked, 4);
}

TEST(PlanPath, ShortcutsAreNeverLongerAndOftenStraight) {
  const AtomMap map = makeGate(1.6F);
  PathRequest request = throughTheGate(0.3F);
  const PlannedPath smooth = plan(map, request);
  request.shortcut = false;
  const PlannedPath raw = plan(map, request);
  EXPECT_LT(smooth.length, raw.length);
  EXPECT_NEAR(smooth.length, (request.goal - request.start).norm(), 1e-4);
}

TEST(PlanPath, AGateIsAsWideAsTheRobotMustBeNarrow) {
  const AtomMap map = makeGate(1.1F);  // the wall's atoms begin 1.25 m from the middle
  EXPECT_EQ(plan(map, throughTheGate(0.9F)).outcome, PathOutcome::kFound);
  const PlannedPath stuck = plan(map, throughTheGate(1.3F));
  EXPECT_EQ(stuck.outcome, PathOutcome::kNoConnection);
  EXPECT_LT(stuck.nearest.x(), 0.0);
  EXPECT_GT(stuck.nearest.x(), throughTheGate(1.3F).start.x() + 1.0);
  EXPECT_GT(stuck.expanded, 10U);
  EXPECT_GT(stuck.seconds, 0.0);
  EXPECT_TRUE(stuck.points.empty());
}

TEST(PlanPath, RefusesEndsThatWillNotDo) {
  const AtomMap map = makeGate(1.1F);
  const auto outcome = [&](const Vector3d& start, const Vector3d& goal) {
    return plan(map, {start, goal, {0.3F, 1.0F, 0.0F}});
  };
  const Vector3d good(-2.0, 0.0, 0.0);
  const struct {
    Vector3d place;
    PathOutcome expected;
  } bad[] = {{{20.0, 0.0, 0.0}, PathOutcome::kUnknown},
             {{0.0, 1.5, 1.5}, PathOutcome::kOccupied},
             {{-0.45, 1.5, 1.5}, PathOutcome::kTooTight}};
  for (const auto& [place, expected] : bad) {
    const PlannedPath at_start = outcome(place, good);
    EXPECT_EQ(at_start.outcome, expected);
    EXPECT_TRUE(at_start.is_start);
    const PlannedPath at_goal = outcome(good, place);
    EXPECT_EQ(at_goal.outcome, expected);
    EXPECT_FALSE(at_goal.is_start);
    EXPECT_TRUE(at_goal.points.empty());
    EXPECT_NEAR(at_goal.room, expected == PathOutcome::kTooTight ? 0.2 : at_goal.room, 1e-5);
  }
  EXPECT_EQ(plan(AtomMap(Mode::kOccupancy, kRadius), throughTheGate(0.3F)).outcome, PathOutcome::kUnknown);
}

TEST(PlanPath, StartMayBeTheGoal) {
  const AtomMap map = makeGate(1.1F);
  const PlannedPath path = plan(map, {Vector3d(1.0, 0.2, 0.1), Vector3d(1.0, 0.2, 0.1), {0.3F, 1.0F, 1.0F}});
  EXPECT_EQ(path.outcome, PathOutcome::kFound);
  EXPECT_EQ(path.length, 0.0);
}

TEST(PlanPath, StopsWhenTimeIsUp) {
  const AtomMap map = makeGate(1.1F);
  PathRequest request = throughTheGate(1.3F);
  request.timeout = 1e-4;
  const PlannedPath path = plan(map, request);
  EXPECT_EQ(path.outcome, PathOutcome::kTimeout);
  EXPECT_LT(path.seconds, 0.5);
}

// A wall comes up while the path is planned.
TEST(PlanPath, PlansAnewWhereTheMapChanged) {
  AtomMap map = makeGate(1.6F);
  int reads = 0;
  const ReadMap read = [&](const std::function<void(const AtomMap&)>& use) {
    use(map);
    if (++reads == 3) map = makeGate(-1.0F);
  };
  const PlannedPath path = planPath(read, throughTheGate(0.3F), GaussianProcessParameters());
  EXPECT_EQ(path.outcome, PathOutcome::kNoConnection);
}

// Surfaces that the regression tells of come nearer while the path is planned; atoms stay free.
TEST(PlanPath, PlansAnewWhereDistancesChanged) {
  const auto make = [](float distance) {
    AtomMap map(Mode::kSignedDistance, kRadius);
    for (int x = -6; x <= 6; ++x) {
      for (int y = -4; y <= 4; ++y) {
        const float values[] = {std::abs(x) > 2 ? 2.0F : distance, 1e-4F};
        for (int z = -4; z <= 4; ++z) map.atoms().insert(0.5F * Eigen::Vector3f(x, y, z), values);
      }
    }
    return map;
  };
  AtomMap map = make(2.0F);
  ASSERT_EQ(plan(map, throughTheGate(0.5F)).outcome, PathOutcome::kFound);
  ASSERT_EQ(plan(make(0.1F), throughTheGate(0.5F)).outcome, PathOutcome::kNoConnection);
  PlannedPath last;
  for (int changed = 1; changed < 200; ++changed) {  // after each of the reads of which planning is made
    map = make(2.0F);
    int reads = 0;
    const ReadMap read = [&](const std::function<void(const AtomMap&)>& use) {
      use(map);
      if (++reads == changed) map = make(0.1F);
    };
    last = planPath(read, throughTheGate(0.5F), GaussianProcessParameters());
    if (reads < changed || (reads == changed && last.outcome == PathOutcome::kFound))
      return;  // it had been looked through
    ASSERT_EQ(last.outcome, PathOutcome::kNoConnection) << "changed after read " << changed;
  }
  FAIL() << "never done";
}

}  // namespace
}  // namespace atom_map
