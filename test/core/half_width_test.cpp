// The width of things that stand free of their background, from simulated scans of poles.
#include "atom_mapping/scan/half_width.h"

#include <gtest/gtest.h>

#include <cmath>

#include "atom_mapping/scan/filter.h"
#include "simulated.h"

namespace atom_map {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kPixel = 0.2 * kDegree;  // angle between firings
constexpr float kMaxWidth = 1.0F;

struct Widths {
  std::vector<float> of_pole;
  std::vector<float> of_rest;
};

Widths measure(std::vector<Solid> solids, double noise = 0.02, double dropout = 0.0) {
  LidarModel model;
  model.noise_sigma = noise;
  model.dropout = dropout;
  const SimulatedScan simulated = scanFromOrigin(std::move(solids), model);
  FilteredScan scan;
  scan.points = toLidarScan(simulated).points;
  const RangeImage image(scan.points, kPixel, 2.0 * kDegree);
  Widths widths;
  for (std::uint32_t i = 0; i < scan.points.size(); ++i) {
    const bool on_pole = simulated.returns[i].kind == SurfaceKind::kPole;
    (on_pole ? widths.of_pole : widths.of_rest).push_back(halfWidth(image, i, scan.points[i], kMaxWidth));
  }
  return widths;
}

bool isNone(float half_width) {
  return std::isinf(half_width);
}

TEST(HalfWidth, OfAPoleIsItsRadiusToAPixel) {
  for (const double radius : {0.05, 0.1, 0.15, 0.3}) {
    for (const double distance : {2.0, 5.0, 9.0}) {
      const Widths widths = measure({makeRoom(14.0), makeUprightPole(distance, 0.7, radius)}, 0.0);
      ASSERT_GE(widths.of_pole.size(), 16U);
      for (const float half_width : widths.of_pole) {
        ASSERT_NEAR(half_width, radius, kPixel * distance + radius * radius / distance) << distance << " m away";
      }
    }
  }
}

TEST(HalfWidth, IsThatOfAPoleBeforeOpenSpaceToo) {
  for (const float half_width : measure({makeUprightPole(4.0, 1.0, 0.1)}).of_pole) ASSERT_NEAR(half_width, 0.1, 0.025);
}

TEST(HalfWidth, SurvivesSingleLostReturns) {
  const Widths widths = measure({makeRoom(14.0), makeUprightPole(3.0, 0.0, 0.15)}, 0.02, 0.1);
  int right = 0;
  for (const float half_width : widths.of_pole) right += std::abs(half_width - 0.15F) < 0.03F ? 1 : 0;
  EXPECT_GE(right, static_cast<int>(0.95 * static_cast<double>(widths.of_pole.size())));
}

TEST(HalfWidth, WallsAndWhatIsWiderThanTheMaximumHaveNone) {
  const Widths widths = measure({makeRoom(8.0, 0.4), makeUprightPole(5.0, 0.0, 0.7)});
  for (const float half_width : widths.of_pole) ASSERT_TRUE(isNone(half_width));
  for (const float half_width : widths.of_rest) ASSERT_TRUE(isNone(half_width));
}

TEST(HalfWidth, WhatSomethingNearerHidesASideOfHasNone) {
  const Pose beside(Eigen::Translation3d(2.0, 1.05, 0.0));
  const Solid screen{makeBox(beside, {0.1, 2.0, 30.0}), SurfaceKind::kWall};  // its edge is seen a quarter pixel aside
  const Widths widths = measure({makeRoom(14.0), screen, makeUprightPole(5.0, 0.22, 0.15)});
  ASSERT_FALSE(widths.of_pole.empty());
  for (const float half_width : widths.of_pole) ASSERT_TRUE(isNone(half_width));
}

TEST(HalfWidth, WallsSeenPastAPoleKeepNone) {
  const Widths widths = measure({makeRoom(8.0), makeUprightPole(3.0, 0.0, 0.05), makeUprightPole(3.0, 1.0, 0.05)});
  for (const float half_width : widths.of_rest) ASSERT_TRUE(isNone(half_width)) << "poles hide a side of it";
}

TEST(HalfWidth, ALoneReturnIsOnePixelWide) {
  FilteredScan scan;
  scan.points = {{6.0F, 0.0F, 0.0F}};
  const RangeImage image(scan.points, kPixel, 2.0 * kDegree);
  EXPECT_NEAR(halfWidth(image, 0, scan.points[0], kMaxWidth), 0.5 * 6.0 * kPixel, 1e-5);
}

}  // namespace
}  // namespace atom_map
