#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "atom_mapping/base/random.h"
#include "atom_mapping/sim/make_scene.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

Vector3d drawPoint(Random& random, double half) {
  const auto draw = [&] { return half * (2.0 * static_cast<double>(random.uniform()) - 1.0); };
  const double x = draw();
  const double y = draw();
  return {x, y, draw()};
}

// Of the inside of a cube of 2 m, exact on both sides.
double distanceInCube(const Vector3d& point) {
  const Vector3d beyond = point.cwiseAbs() - Vector3d::Ones();
  if (beyond.maxCoeff() <= 0.0) return -beyond.maxCoeff();
  return -beyond.cwiseMax(0.0).norm();
}

std::set<SurfaceKind> kindsOf(const Scene& scene) {
  std::set<SurfaceKind> kinds;
  for (const Solid& solid : scene.solids()) kinds.insert(solid.kind);
  return kinds;
}

TEST(SimMakeScene, CubeIsExactEverywhere) {
  const Scene scene = makeScene("cube");
  Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const Vector3d point = drawPoint(random, 2.0);
    EXPECT_NEAR(scene.signedDistance(point), distanceInCube(point), 1e-12);
  }
}

TEST(SimMakeScene, RotatedCubeIsTheCubeAboutAGeneralAxis) {
  const Scene scene = makeScene("cube_rotated");
  const Eigen::AngleAxisd turn(0.6, Vector3d(1.0, 2.0, 3.0).normalized());
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const Vector3d point = drawPoint(random, 2.0);
    EXPECT_NEAR(scene.signedDistance(turn * point), distanceInCube(point), 1e-9);
  }
}

TEST(SimMakeScene, SphereIsExactEverywhere) {
  const Scene scene = makeScene("sphere");
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    const Vector3d point = drawPoint(random, 2.0);
    EXPECT_NEAR(scene.signedDistance(point), 1.0 - point.norm(), 1e-12);
  }
}

TEST(SimMakeScene, UnknownNameIsAnsweredWithTheNamesThereAre) {
  try {
    makeScene("moon");
    FAIL() << "no throw";
  } catch (const std::invalid_argument& error) {
    for (const std::string& name : sceneNames()) EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
  }
}

TEST(SimMakeScene, HallAndCampusHaveTheirSizes) {
  EXPECT_TRUE(makeScene("hall").bounds().sizes().isApprox(Vector3d(68.0, 65.0, 17.0)));
  EXPECT_TRUE(makeScene("campus").bounds().sizes().isApprox(Vector3d(168.0, 90.0, 35.0)));
}

TEST(SimMakeScene, HallAndCampusHavePolesOfFiveCentimetres) {
  for (const char* name : {"hall", "campus"}) {
    int poles = 0;
    const Scene scene = makeScene(name);
    for (const Solid& solid : scene.solids()) {
      const auto* cylinder = std::get_if<Cylinder>(&solid.shape);
      if (solid.kind == SurfaceKind::kPole && cylinder != nullptr && cylinder->radius == 0.05) ++poles;
      EXPECT_TRUE(!isThin(solid.kind) || cylinder->radius < 0.2);
    }
    EXPECT_GE(poles, 10) << name;
  }
}

TEST(SimMakeScene, HallAndCampusShowWhatTheyPromise) {
  using Kind = SurfaceKind;
  const std::set<Kind> hall = kindsOf(makeScene("hall"));
  for (const Kind kind : {Kind::kWall, Kind::kColumn, Kind::kPole, Kind::kBox, Kind::kRamp})
    EXPECT_EQ(hall.count(kind), 1U);
  const std::set<Kind> campus = kindsOf(makeScene("campus"));
  for (const Kind kind : {Kind::kGround, Kind::kWall, Kind::kPole, Kind::kTrunk, Kind::kTree, Kind::kCar}) {
    EXPECT_EQ(campus.count(kind), 1U) << toString(kind);
  }
}

TEST(SimMakeScene, FloorOfTheHallIsGroundAndItsShellIsExact) {
  const Scene hall = makeScene("hall");
  const auto floor = hall.castRay({18.0, 13.5, 1.0}, -Vector3d::UnitZ(), 10.0);
  ASSERT_TRUE(floor);
  EXPECT_EQ(floor->kind, SurfaceKind::kGround);
  for (const double depth : {0.1, 0.5, 1.0}) EXPECT_NEAR(hall.signedDistance({18.0, 13.5, -depth}), -depth, 1e-12);
}

TEST(SimMakeScene, GroundOfTheCampusLiesAtItsHeight) {
  const Scene campus = makeScene("campus");
  for (const double x : {-60.0, -45.0, 0.0, 30.0, 45.0}) {
    EXPECT_NEAR(campus.signedDistance({x, -16.0, campusGroundHeight(x, -16.0)}), 0.0, 1e-9) << x;
  }
}

}  // namespace
}  // namespace atom_map
