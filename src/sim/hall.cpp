// A hall of 68 x 65 x 17 m: columns and girders, containers, crates, a dock with a ramp and posts, vehicles, signs.
#include "atom_mapping/base/angles.h"
#include "atom_mapping/base/random.h"
#include "atom_mapping/sim/make_scene.h"
#include "atom_mapping/sim/scene_parts.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 68.0;
constexpr double kWidth = 65.0;
constexpr double kHeight = 17.0;
constexpr double kColumnRows[] = {-24.0, -12.0, 0.0, 12.0, 24.0};  // x of the columns and of the girders over them

Place floorAt(double x, double y, double yaw = 0.0) {
  return {{x, y, 0.0}, yaw};
}

void addShell(Solids& scene) {
  const Vector3d size(kLength, kWidth, kHeight);
  scene.push_back({makeBox(floorAt(0, 0).at(0, 0, 0.5 * kHeight).pose(), size), SurfaceKind::kWall, true});
  for (double x = -28.0; x <= 28.0; x += 8.0) {
    for (const double y : {-0.5 * kWidth, 0.5 * kWidth}) {
      addStandingBox(scene, floorAt(x, y), {0.9, 1.0, kHeight + kFoundation}, SurfaceKind::kWall);  // pilasters
    }
  }
  for (double y = -24.0; y <= 24.0; y += 12.0) {
    addBox(scene, {{0.0, y, kHeight - 0.5}}, {kLength + 2.0, 0.3, 2.5}, SurfaceKind::kWall);  // purlins
  }
  addStandingBox(scene, floorAt(-29.0, 8.0, 0.45), {9.0, 0.3, 4.0}, SurfaceKind::kWall);  // a partition askew
}

void addColumns(Solids& scene) {
  for (const double x : kColumnRows) {
    for (const double y : {-20.0, -7.0, 7.0, 20.0}) {
      addStandingCylinder(scene, floorAt(x, y), 0.45, kHeight + 1.0, SurfaceKind::kColumn);
      addBox(scene, {{x, y, kHeight - 2.1}}, {1.4, 1.4, 0.5}, SurfaceKind::kColumn);
    }
    addBox(scene, {{x, 0.0, kHeight - 1.6}}, {0.5, kWidth + 2.0, 3.6}, SurfaceKind::kWall);  // girder
  }
}

// Freight containers, end to end and some two high, 18 m along the place's x axis.
void addContainers(Solids& scene, const Place& place, std::uint64_t variant) {
  Random random(variant);
  for (const double x : {-6.2, 0.0, 6.2}) {
    addStandingBox(scene, place.at(x, 0.0), {6.06, 2.44, 2.59}, SurfaceKind::kBox);
    if (random.uniform() < 0.5F) continue;
    addBox(scene, place.at(x + 0.3 * random.uniform(), 0.0, 2.5), {6.06, 2.44, 2.59}, SurfaceKind::kBox);
  }
}

// Crates strewn around a place, some with a second one on top.
void addCrates(Solids& scene, const Place& place, std::uint64_t variant) {
  Random random(variant);
  for (int i = 0; i < 4; ++i) {
    const double side = 1.2 + 0.8 * random.uniform();
    const int row = i / 2;
    Place crate = place.at(2.9 * (i % 2) + 0.3 * random.uniform(), 2.9 * row + 0.3 * random.uniform());
    crate.yaw += 0.8 * random.uniform();
    addStandingBox(scene, crate, {side, side, 0.9 * side}, SurfaceKind::kBox);
    if (random.uniform() < 0.4F) addBox(scene, crate.at(0, 0, 0.85 * side), Vector3d::Constant(1.1), SurfaceKind::kBox);
  }
}

// A platform along the east wall, a ramp up to it, and thin posts along its edge.
void addDock(Solids& scene) {
  addStandingBox(scene, floorAt(31.0, 4.0), {8.0, 24.0, 1.2}, SurfaceKind::kRamp);
  addRamp(scene, floorAt(31.0, -18.0, 0.5 * kPi), 9.0, 2.0, 1.2, 4.0);
  for (double y = -7.5; y <= 15.6; y += 2.1) {
    scene.push_back({Cylinder{{27.3, y, -1.0}, 0.025, 3.3}, SurfaceKind::kPole});
  }
  addCrates(scene, {{30.0, 10.0, 1.2}}, 71);
  addStandingBox(scene, floorAt(33.0, 0.0), {3.0, 5.0, 4.6}, SurfaceKind::kWall);  // an office on the dock
}

void addGoods(Solids& scene) {
  const double rows[] = {-28.5, -24.0, 24.5, 28.5};
  std::uint64_t variant = 11;
  for (const double y : rows) {
    for (const double x : {-19.0, 4.0}) addContainers(scene, floorAt(x, y), ++variant);
  }
  for (const double x : {-7.5, 6.5}) {
    for (const double y : {-4.0, 2.0}) addCrates(scene, floorAt(x, y, 0.2 * x), ++variant);
  }
  addCrates(scene, floorAt(-29.0, -12.0), 41);
  addCrates(scene, floorAt(-8.0, 17.5, 0.4), 42);
  addCrates(scene, floorAt(20.5, -28.0, 1.1), 43);
  for (int i = 0; i < 5; ++i) {
    const int row = i / 3;
    addStandingCylinder(scene, floorAt(-0.5 + 0.7 * (i % 3), -17.5 - 0.75 * row), 0.3, 0.9, SurfaceKind::kBox);
  }
  scene.push_back({Sphere{{3.0, 0.0, 1.4}, 1.5}, SurfaceKind::kBox});  // a tank, on a plinth
  addStandingBox(scene, floorAt(3.0, 0.0), {1.6, 1.6, 0.4}, SurfaceKind::kBox);
  addCar(scene, floorAt(-27.0, 27.5, -0.5 * kPi));
  addCar(scene, floorAt(22.0, 20.0, 0.3));
}

void addPoles(Solids& scene) {
  for (const double x : {-15.0, -5.0, 5.0, 15.0}) {
    addPole(scene, floorAt(x, 10.5), 2.6);
    addSign(scene, floorAt(x, -10.5, 0.5 * kPi), 3.2);
    addPole(scene, floorAt(x, -16.5), 4.5);
    addSign(scene, floorAt(x, 16.5, -0.5 * kPi), 2.8);
  }
  for (const double y : {-9.0, 0.0, 9.0}) {
    addPole(scene, floorAt(-21.0, y), 6.0);
    addPole(scene, floorAt(14.5, y), 3.0);
  }
}

}  // namespace

Scene makeHall() {
  Solids scene;
  addShell(scene);
  addColumns(scene);
  addDock(scene);
  addGoods(scene);
  addPoles(scene);
  const Vector3d half(0.5 * kLength, 0.5 * kWidth, 0.0);
  return Scene("hall", std::move(scene), {-half, half + kHeight * Vector3d::UnitZ()});
}

}  // namespace atom_map
