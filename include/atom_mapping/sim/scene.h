// A world of solids with exact truth. Map frame, metres, double precision.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "atom_mapping/sim/convex_polyhedron.h"
#include "atom_mapping/sim/shapes.h"

namespace atom_map {

// kPole and kTrunk are the thin ones: poles have a radius of at most 0.1 m, trunks of less than 0.2 m.
enum class SurfaceKind { kGround, kWall, kColumn, kPole, kTrunk, kTree, kBox, kCar, kRamp };

std::string toString(SurfaceKind kind);

inline bool isThin(SurfaceKind kind) {
  return kind == SurfaceKind::kPole || kind == SurfaceKind::kTrunk;
}

using Shape = std::variant<Sphere, Cylinder, ConvexPolyhedron>;

struct Solid {
  Shape shape;
  SurfaceKind kind;
  bool hollow = false;  // the matter is outside of the shape: a room, or the ground under an open valley
};

struct Nearest {
  double distance;         // signed: positive in free space, negative in a solid
  Eigen::Vector3d normal;  // gradient of the distance; on a surface its unit normal towards free space
  SurfaceKind kind;
};

struct Hit {
  double range;            // along the ray
  Eigen::Vector3d point;   // map frame
  Eigen::Vector3d normal;  // unit, towards free space
  SurfaceKind kind;
};

// The union of some solids.
//
// In free space every distance and every ray is exact (to rounding, some 1e-10 m). In a solid the distance is exact
// where its nearest face is not buried in another solid; otherwise its size is too small, never too large. A scene of
// one solid is therefore exact everywhere. makeScene sinks what stands on the ground 2 m into it, so that below the
// ground and in what stands on it depths up to 2 m are exact, save under the foot of an object and where objects touch
// one another.
class Scene {
 public:
  // `bounds` is the space of interest: inside a closed scene, around what an open one shows.
  Scene(std::string name, std::vector<Solid> solids, const Eigen::AlignedBox3d& bounds);

  Nearest nearest(const Eigen::Vector3d& point) const;
  double signedDistance(const Eigen::Vector3d& point) const { return nearest(point).distance; }

  // The first surface along a unit direction from an origin in free space; none within max_range, no value.
  std::optional<Hit> castRay(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double max_range) const;

  const std::string& name() const { return name_; }
  const std::vector<Solid>& solids() const { return solids_; }
  const Eigen::AlignedBox3d& bounds() const { return bounds_; }

 private:
  std::string name_;
  std::vector<Solid> solids_;
  std::vector<BoundingSphere> bounding_spheres_;  // of the matter, one a solid
  Eigen::AlignedBox3d bounds_;
};

}  // namespace atom_map
