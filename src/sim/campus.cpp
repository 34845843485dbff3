// A campus of 168 x 90 x 35 m: a ring road around two halls, a tower and houses, parked cars, trees, lamps and signs.
#include <algorithm>
#include <utility>

#include "atom_mapping/base/angles.h"
#include "atom_mapping/base/random.h"
#include "atom_mapping/sim/make_scene.h"
#include "atom_mapping/sim/scene_parts.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

// Height is the greatest of these planes, a x + b y + c: a shallow valley.
constexpr double kGroundPlanes[][3] = {
    {-0.012, 0.0, 0.0}, {0.035, 0.0, -1.33}, {0.0, -0.06, -1.6}, {0.004, 0.05, -1.5}};

Place groundAt(double x, double y, double yaw = 0.0) {
  return {{x, y, campusGroundHeight(x, y)}, yaw};
}

void addGround(Solids& scene) {
  std::vector<Plane> faces;
  for (const auto& [a, b, c] : kGroundPlanes) {
    faces.emplace_back(Vector3d(a, b, -1.0).normalized(), Vector3d(0.0, 0.0, c));
  }
  scene.push_back({ConvexPolyhedron(std::move(faces)), SurfaceKind::kGround, true});
}

// A flat-roofed block with bays between pilasters on its long sides, floor slabs that stand out and boxes on its roof.
void addBlock(Solids& scene, const Place& place, const Vector3d& size) {
  addStandingBox(scene, place, size, SurfaceKind::kWall);
  for (double x = -0.5 * size.x() + 2.0; x < 0.5 * size.x(); x += 4.0) {
    addStandingBox(scene, place.at(x, 0.0), {0.5, size.y() + 0.6, size.z() + 0.4}, SurfaceKind::kWall);
  }
  for (double z = 3.2; z < size.z() - 1.0; z += 3.4) {
    addBox(scene, place.at(0.0, 0.0, z), {size.x() + 0.3, size.y() + 0.3, 0.3}, SurfaceKind::kWall);
  }
  addBox(scene, place.at(0.2 * size.x(), 0.0, size.z() - 1.0), {3.0, 3.0, 3.0}, SurfaceKind::kWall);
}

// Gabled, with a chimney, a porch on two columns and steps on its south side.
void addHouse(Solids& scene, const Place& place, const Vector3d& size, double roof) {
  const Place turned{place.position, place.yaw + 0.5 * kPi};
  addGabledHouse(scene, turned, {size.y(), size.x(), size.z()}, roof);
  addBox(scene, place.at(0.25 * size.x(), 0.2 * size.y(), size.z() - 1.0), {0.9, 0.9, roof + 1.8}, SurfaceKind::kWall);
  const double front = -0.5 * size.y();
  addBox(scene, place.at(0.0, front - 1.0, 2.9), {4.4, 3.0, 0.35}, SurfaceKind::kWall);
  for (const double x : {-1.8, 1.8})
    addStandingCylinder(scene, place.at(x, front - 2.1), 0.18, 3.0, SurfaceKind::kColumn);
  for (int i = 0; i < 3; ++i) {
    addStandingBox(scene, place.at(0.0, front), {3.2, 2.6 - 0.7 * i, 0.17 * (i + 1)}, SurfaceKind::kRamp);
  }
}

void addBuildings(Solids& scene) {
  addHouse(scene, groundAt(-20.0, 1.0), {26.0, 13.0, 7.5}, 4.5);
  addBlock(scene, groundAt(19.0, 0.0), {24.0, 13.0, 14.0});
  addRamp(scene, groundAt(1.5, 0.0), 4.5, 1.5, 0.9, 2.6);
  addHouse(scene, groundAt(-55.0, 35.0), {30.0, 12.0, 6.0}, 4.0);
  addBlock(scene, groundAt(2.0, 36.0), {38.0, 13.0, 17.5});
  addBlock(scene, groundAt(60.0, 33.0), {13.0, 13.0, 31.0});
  addHouse(scene, groundAt(-44.0, -37.0, kPi), {24.0, 11.0, 4.5}, 3.5);
  addBlock(scene, groundAt(16.0, -38.0), {34.0, 11.0, 9.0});
  addStandingBox(scene, groundAt(-83.0, 0.0), {0.4, 80.0, 2.4}, SurfaceKind::kWall);
  addStandingBox(scene, groundAt(83.0, 0.0), {0.4, 80.0, 2.4}, SurfaceKind::kWall);
}

void addCars(Solids& scene) {
  for (const double x : {-38.0, -31.5, -19.0, 6.0, 12.5, 25.0, 38.5}) addCar(scene, groundAt(x, 20.0));
  for (const double x : {-33.0, -10.0, 1.0, 30.0}) addCar(scene, groundAt(x, -20.2, kPi));
  for (const double y : {-24.0, -18.0, -15.0, -9.0, -6.0, 3.0, 9.0}) addCar(scene, groundAt(58.0, y, 0.04 * y));
  for (const double y : {-21.0, -12.0, -3.0, 0.0, 6.0}) addCar(scene, groundAt(67.0, y, kPi + 0.02 * y));
}

void addTrees(Solids& scene) {
  Random random(2017);
  const auto add = [&](double x, double y) {
    const double size = 0.85 + 0.5 * random.uniform();
    addTree(scene, groundAt(x + 1.5 * random.uniform(), y + 1.5 * random.uniform()), size, random.next());
  };
  for (double x = -40.0; x <= 40.0; x += 11.5) add(x, -25.0);
  for (double x = -70.0; x <= 46.0; x += 13.5) add(x, 24.0);
  for (double x = -78.0; x <= -56.0; x += 7.5) {
    for (double y = -30.0; y <= 15.0; y += 9.5) add(x, y);  // a grove
  }
  for (const double y : {-30.0, -5.0, 15.0}) add(75.0, y);
  for (const double x : {-3.5, 36.0}) add(x, 3.0);
  for (const double x : {-30.0, -12.0})
    addStandingBox(scene, groundAt(x, -9.5), {9.0, 0.9, 1.1}, SurfaceKind::kTree);  // hedges
}

void addStreetFurniture(Solids& scene) {
  for (double x = -40.0; x <= 40.0; x += 16.0) {
    addStreetLamp(scene, groundAt(x, 13.2, 0.5 * kPi), 6.0);
    addStreetLamp(scene, groundAt(x + 8.0, -13.2, -0.5 * kPi), 6.0);
  }
  for (const double y : {-9.0, 0.0, 9.0}) {
    addStreetLamp(scene, groundAt(-48.5, y), 5.0);
    addSign(scene, groundAt(48.5, y + 2.0, kPi), 2.6);
    addSign(scene, groundAt(-41.5, y - 2.0, kPi), 2.4);
  }
  for (double x = -2.5; x <= 4.5; x += 1.4)
    addStandingCylinder(scene, groundAt(x, -11.5), 0.08, 0.9, SurfaceKind::kPole);
  for (const double x : {-24.0, -16.0, 10.0, 22.0}) {
    addBox(scene, groundAt(x, 11.0).at(0, 0, 0.4), {1.8, 0.45, 0.08}, SurfaceKind::kBox);  // bench
    for (const double leg : {-0.7, 0.7})
      addStandingBox(scene, groundAt(x + leg, 11.0), {0.1, 0.4, 0.42}, SurfaceKind::kBox);
  }
  for (const double x : {-29.0, 33.0}) addStandingBox(scene, groundAt(x, 22.8), {3.0, 1.4, 1.6}, SurfaceKind::kBox);
}

}  // namespace

double campusGroundHeight(double x, double y) {
  double height = -1e9;
  for (const auto& [a, b, c] : kGroundPlanes) height = std::max(height, a * x + b * y + c);
  return height;
}

Scene makeCampus() {
  Solids scene;
  addGround(scene);
  addBuildings(scene);
  addCars(scene);
  addTrees(scene);
  addStreetFurniture(scene);
  return Scene("campus", std::move(scene), {Vector3d(-84.0, -45.0, -1.0), Vector3d(84.0, 45.0, 34.0)});
}

}  // namespace atom_map
