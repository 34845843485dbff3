// What the scenes are put together from. Each adds solids to `scene`; metres, map frame, angles in radians.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "atom_mapping/sim/scene.h"

namespace atom_map {

using Solids = std::vector<Solid>;

// How deep whatever stands on the ground reaches into it.
constexpr double kFoundation = 2.0;

// A place on the ground and the direction that a thing's x axis faces.
struct Place {
  Eigen::Vector3d position;
  double yaw = 0.0;

  Eigen::Isometry3d pose() const;
  Place at(double x, double y, double z = 0.0) const;  // in this place's own axes
};

// Box whose lower face is centred on the place; `size` is along its own axes.
void addBox(Solids& scene, const Place& place, const Eigen::Vector3d& size, SurfaceKind kind);

// The same, reaching down into the ground.
void addStandingBox(Solids& scene, const Place& place, const Eigen::Vector3d& size, SurfaceKind kind);

void addStandingCylinder(Solids& scene, const Place& place, double radius, double height, SurfaceKind kind);

// 5 cm of radius.
void addPole(Solids& scene, const Place& place, double height);

// A pole with a board at its top.
void addSign(Solids& scene, const Place& place, double height);

// A pole with an arm and a lamp that hang out along the place's x axis.
void addStreetLamp(Solids& scene, const Place& place, double height);

// Trunk of 0.12 to 0.18 m of radius and a crown of some spheres; `size` scales it (1: some 7 m high), `variant` seeds
// it.
void addTree(Solids& scene, const Place& place, double size, std::uint64_t variant);

// 4.4 x 1.8 x 1.5 m: body, cabin and four wheels.
void addCar(Solids& scene, const Place& place);

// Rises along the place's x axis from the ground to `height`, then stays level for `landing`.
void addRamp(Solids& scene, const Place& place, double length, double landing, double height, double width);

// Walls and a gable roof whose ridge runs along the place's y axis.
void addGabledHouse(Solids& scene, const Place& place, const Eigen::Vector3d& size, double roof_height);

}  // namespace atom_map
