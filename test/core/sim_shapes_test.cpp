// Every shape against its own surface, sampled densely by lines through it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "atom_mapping/base/random.h"
#include "atom_mapping/sim/convex_polyhedron.h"
#include "atom_mapping/sim/shapes.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

Vector3d drawPoint(Random& random, double half) {
  const auto draw = [&] { return half * (2.0 * static_cast<double>(random.uniform()) - 1.0); };
  const double x = draw();
  const double y = draw();
  return {x, y, draw()};
}

Eigen::Isometry3d generalPose() {
  return Eigen::Translation3d(0.3, -0.2, 0.4) * Eigen::AngleAxisd(0.7, Vector3d(1.0, -2.0, 0.5).normalized());
}

// A shape of less than 3 m about the origin.
struct ShapeCase {
  const char* name;
  std::function<SurfaceDistance(const Vector3d&)> nearest;
  std::function<std::optional<Chord>(const Vector3d&, const Vector3d&)> chord;
  BoundingSphere bound;
};

template <typename Shape>
ShapeCase makeCase(const char* name, const Shape& shape) {
  return {name, [shape](const Vector3d& p) { return shape.nearest(p); },
          [shape](const Vector3d& o, const Vector3d& d) { return shape.chord(o, d); }, shape.bound()};
}

std::vector<ShapeCase> shapes() {
  return {makeCase("sphere", Sphere{{0.2, 0.1, -0.3}, 1.3}),
          makeCase("pillar", Cylinder{{0.1, -0.2, -1.5}, 0.3, 2.5}),
          makeCase("disc", Cylinder{{0.1, -0.2, 0.5}, 1.6, 0.2}),
          makeCase("box", makeBox(generalPose(), {2.0, 1.0, 0.3})),
          makeCase("wedge", makePrism(generalPose(), {{-1.5, -0.5}, {1.5, -0.5}, {1.5, 0.4}}, 1.2)),
          makeCase("house", makePrism(generalPose(), {{-1, -1}, {1, -1}, {1, 0.5}, {0, 1.2}, {-1, 0.5}}, 2.0))};
}

class SimShapes : public testing::TestWithParam<ShapeCase> {
 protected:
  // Where random lines enter and leave.
  std::vector<Vector3d> sampleSurface(int lines) const {
    Random random(5);
    std::vector<Vector3d> samples;
    for (int i = 0; i < lines; ++i) {
      const Vector3d direction = drawPoint(random, 1.0).normalized();
      const Vector3d origin = drawPoint(random, 2.0) - 10.0 * direction;
      if (const auto chord = GetParam().chord(origin, direction)) {
        samples.emplace_back(origin + chord->enter * direction);
        samples.emplace_back(origin + chord->leave * direction);
      }
    }
    return samples;
  }
};

TEST_P(SimShapes, DistanceIsThatToTheNearestOfManySurfacePoints) {
  const std::vector<Vector3d> surface = sampleSurface(200000);
  ASSERT_GT(surface.size(), 5000U);
  Random random(6);
  for (int i = 0; i < 300; ++i) {
    const Vector3d point = drawPoint(random, 3.0);
    const double distance = std::abs(GetParam().nearest(point).distance);
    double least = std::numeric_limits<double>::infinity();
    for (const Vector3d& sample : surface) least = std::min(least, (sample - point).norm());
    EXPECT_LE(distance, least + 1e-9);
    EXPECT_GE(distance, least - 0.1) << "samples lie some 3 cm apart";
  }
}

TEST_P(SimShapes, NormalLeadsFromTheNearestSurfacePoint) {
  Random random(7);
  for (int i = 0; i < 5000; ++i) {
    const Vector3d point = drawPoint(random, 3.0);
    const SurfaceDistance found = GetParam().nearest(point);
    EXPECT_NEAR(found.normal.norm(), 1.0, 1e-12);
    EXPECT_NEAR(GetParam().nearest(point - found.distance * found.normal).distance, 0.0, 1e-9);
  }
}

TEST_P(SimShapes, DistanceIsNegativeWhereAChordRunsThroughThePoint) {
  Random random(8);
  for (int i = 0; i < 5000; ++i) {
    const Vector3d point = drawPoint(random, 2.0);
    const auto chord = GetParam().chord(point, drawPoint(random, 1.0).normalized());
    EXPECT_EQ(GetParam().nearest(point).distance < 0.0, chord.has_value() && chord->enter < 0.0);
  }
}

TEST_P(SimShapes, ChordEndsOnTheSurfaceAndKnowsItsNormals) {
  Random random(9);
  for (int i = 0; i < 5000; ++i) {
    const Vector3d direction = drawPoint(random, 1.0).normalized();
    const Vector3d origin = drawPoint(random, 1.0) - 8.0 * direction;
    const auto chord = GetParam().chord(origin, direction);
    if (!chord) continue;
    const Vector3d enter = origin + chord->enter * direction;
    const Vector3d leave = origin + chord->leave * direction;
    EXPECT_NEAR(GetParam().nearest(enter).distance, 0.0, 1e-9);
    EXPECT_NEAR(GetParam().nearest(leave).distance, 0.0, 1e-9);
    EXPECT_NEAR(GetParam().nearest(enter + 0.2 * chord->enter_normal).distance, 0.2, 1e-9);
    EXPECT_NEAR(GetParam().nearest(leave + 0.2 * chord->leave_normal).distance, 0.2, 1e-9);
  }
}

TEST_P(SimShapes, BoundingSphereHoldsTheSurface) {
  for (const Vector3d& sample : sampleSurface(20000)) {
    EXPECT_LE((sample - GetParam().bound.center).norm(), GetParam().bound.radius + 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(All, SimShapes, testing::ValuesIn(shapes()),
                         [](const auto& instance) { return instance.param.name; });

TEST(SimUnboundedShapes, WedgeOfTwoPlanesIsExactAtItsEdge) {
  const ConvexPolyhedron wedge({Plane(Vector3d::UnitX(), 0.0), Plane(Vector3d::UnitZ(), 0.0)});
  EXPECT_DOUBLE_EQ(wedge.nearest({3.0, 7.0, 4.0}).distance, 5.0);
  EXPECT_DOUBLE_EQ(wedge.nearest({-1.0, 7.0, 4.0}).distance, 4.0);
  EXPECT_DOUBLE_EQ(wedge.nearest({-1.0, 7.0, -4.0}).distance, -1.0);
  EXPECT_TRUE(std::isinf(wedge.bound().radius));
}

}  // namespace
}  // namespace atom_map
