#include "atom_mapping/sim/scene_parts.h"

#include <cmath>

#include "atom_mapping/base/random.h"

namespace atom_map {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Isometry3d Place::pose() const {
  return Eigen::Translation3d(position) * Eigen::AngleAxisd(yaw, Vector3d::UnitZ());
}

Place Place::at(double x, double y, double z) const {
  return {pose() * Vector3d(x, y, z), yaw};
}

void addBox(Solids& scene, const Place& place, const Vector3d& size, SurfaceKind kind) {
  scene.push_back({makeBox(place.at(0.0, 0.0, 0.5 * size.z()).pose(), size), kind});
}

void addStandingBox(Solids& scene, const Place& place, const Vector3d& size, SurfaceKind kind) {
  addBox(scene, place.at(0.0, 0.0, -kFoundation), size + kFoundation * Vector3d::UnitZ(), kind);
}

void addStandingCylinder(Solids& scene, const Place& place, double radius, double height, SurfaceKind kind) {
  scene.push_back({Cylinder{place.at(0.0, 0.0, -kFoundation).position, radius, height + kFoundation}, kind});
}

void addPole(Solids& scene, const Place& place, double height) {
  addStandingCylinder(scene, place, 0.05, height, SurfaceKind::kPole);
}

void addSign(Solids& scene, const Place& place, double height) {
  addPole(scene, place, height);
  addBox(scene, place.at(0.06, 0.0, height - 0.65), {0.04, 0.6, 0.6}, SurfaceKind::kBox);
}

void addStreetLamp(Solids& scene, const Place& place, double height) {
  addPole(scene, place, height);
  addBox(scene, place.at(0.6, 0.0, height - 0.1), {1.3, 0.08, 0.08}, SurfaceKind::kBox);
  addBox(scene, place.at(1.4, 0.0, height - 0.15), {0.7, 0.3, 0.16}, SurfaceKind::kBox);
}

void addTree(Solids& scene, const Place& place, double size, std::uint64_t variant) {
  Random random(variant);
  const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
  const double trunk = size * between(2.6, 3.4);
  addStandingCylinder(scene, place, between(0.12, 0.18), trunk + 0.8 * size, SurfaceKind::kTrunk);
  const double girth = size * between(1.5, 1.9);
  scene.push_back({Sphere{place.at(0.0, 0.0, trunk + girth).position, girth}, SurfaceKind::kTree});
  scene.push_back({Sphere{place.at(0.0, 0.0, trunk + 1.9 * girth).position, 0.75 * girth}, SurfaceKind::kTree});
  for (int i = 0; i < 3; ++i) {
    const double angle = 2.1 * i + between(0.0, 0.8);
    const double out = between(0.6, 0.8) * girth;
    const Place lobe = place.at(out * std::cos(angle), out * std::sin(angle), trunk + between(0.9, 1.3) * girth);
    scene.push_back({Sphere{lobe.position, between(0.6, 0.75) * girth}, SurfaceKind::kTree});
  }
}

void addCar(Solids& scene, const Place& place) {
  const SurfaceKind kind = SurfaceKind::kCar;
  const std::vector<Vector2d> body = {{-2.1, 0.3}, {2.0, 0.3},   {2.2, 0.5}, {2.15, 0.75},
                                      {0.9, 0.9},  {-2.1, 0.95}, {-2.2, 0.5}};
  const std::vector<Vector2d> cabin = {{-1.9, 0.8}, {1.1, 0.8}, {0.3, 1.45}, {-1.3, 1.5}};
  scene.push_back({makePrism(place.pose(), body, 1.8), kind});
  scene.push_back({makePrism(place.pose(), cabin, 1.55), kind});
  for (const double x : {-1.35, 1.35}) {
    for (const double y : {-0.8, 0.8}) addBox(scene, place.at(x, y, -0.2), {0.55, 0.2, 0.8}, kind);
  }
}

void addRamp(Solids& scene, const Place& place, double length, double landing, double height, double width) {
  const double end = length + landing;
  const std::vector<Vector2d> profile = {
      {0.0, -kFoundation}, {end, -kFoundation}, {end, height}, {length, height}, {0.0, 0.0}};
  scene.push_back({makePrism(place.pose(), profile, width), SurfaceKind::kRamp});
}

void addGabledHouse(Solids& scene, const Place& place, const Vector3d& size, double roof_height) {
  const double x = 0.5 * size.x();
  const double top = size.z();
  const std::vector<Vector2d> profile = {
      {-x, -kFoundation}, {x, -kFoundation}, {x, top}, {0.0, top + roof_height}, {-x, top}};
  scene.push_back({makePrism(place.pose(), profile, size.y()), SurfaceKind::kWall});
}

}  // namespace atom_map
