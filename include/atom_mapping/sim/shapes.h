// Convex shapes with exact distances and exact ray crossings. Map frame, metres; normals are unit and point out of the
// shape.
#pragma once

#include <Eigen/Geometry>
#include <optional>

namespace atom_map {

struct SurfaceDistance {
  double distance;         // Euclidean distance to the shape's surface, negative inside
  Eigen::Vector3d normal;  // gradient of the distance
};

// Where a line is inside a shape. `leave` is not negative; `enter` is, where the origin lies inside.
struct Chord {
  double enter;
  double leave;
  Eigen::Vector3d enter_normal;
  Eigen::Vector3d leave_normal;
};

// A ball that holds a whole shape; its radius is infinite for an unbounded shape.
struct BoundingSphere {
  Eigen::Vector3d center;
  double radius;
};

struct Sphere {
  Eigen::Vector3d center;
  double radius;

  SurfaceDistance nearest(const Eigen::Vector3d& point) const;
  std::optional<Chord> chord(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;
  BoundingSphere bound() const { return {center, radius}; }
};

// Upright and capped: `base` is the centre of the lower cap.
struct Cylinder {
  Eigen::Vector3d base;
  double radius;
  double height;

  SurfaceDistance nearest(const Eigen::Vector3d& point) const;
  std::optional<Chord> chord(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;
  BoundingSphere bound() const;
};

}  // namespace atom_map
