#include <gtest/gtest.h>

#include "drive_paths.h"

namespace atom_map {
namespace {

TEST(HallPaths, ReachTheirFigures) {
  const PathWorld hall("hall");
  expectGoodPaths(hall.plan(200, 0.0));
  double last = 1e9;
  for (const double surface_weight : {0.0, 1.0, 4.0}) {
    const PathFigures figures = hall.plan(40, surface_weight);
    EXPECT_LT(figures.deviation, last);
    EXPECT_GE(figures.nearest, kRobot - 0.5 * kAtom);
    last = figures.deviation;
  }
}

// Atoms lie near surfaces only, and so must start and goal.
TEST(HallPaths, InSignedDistanceModeTheyFollowSurfaces) {
  const PathWorld hall("hall", Mode::kSignedDistance);
  const PathFigures figures = hall.plan(40, 0.0, 1.0);
  EXPECT_GE(figures.found, 20);
  EXPECT_GE(figures.nearest, kRobot - 0.5 * kAtom);
}

}  // namespace
}  // namespace atom_map
