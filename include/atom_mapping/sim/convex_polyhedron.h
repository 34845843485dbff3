#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "atom_mapping/sim/shapes.h"

namespace atom_map {

using Plane = Eigen::Hyperplane<double, 3>;

// The points behind every one of some planes; may be unbounded. Distances are exact on both sides.
class ConvexPolyhedron {
 public:
  // Unit normals outward. The intersection must not be empty.
  explicit ConvexPolyhedron(std::vector<Plane> faces);

  SurfaceDistance nearest(const Eigen::Vector3d& point) const;
  std::optional<Chord> chord(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;
  BoundingSphere bound() const;

 private:
  // Part of a line, from `start` to `end` metres along it; either may be infinite.
  struct Edge {
    Eigen::Vector3d point;
    Eigen::Vector3d direction;
    double start;
    double end;
  };

  std::optional<Edge> clipToFaces(Edge line, std::size_t i, std::size_t j) const;
  void findEdges();
  bool contains(const Eigen::Vector3d& point) const;
  SurfaceDistance nearestOutside(const Eigen::Vector3d& point) const;

  std::vector<Plane> faces_;
  std::vector<Edge> edges_;
};

// Box centred at the pose's origin.
ConvexPolyhedron makeBox(const Eigen::Isometry3d& pose, const Eigen::Vector3d& size);

// A convex polygon of the pose's xz plane, counter-clockwise with x to the right and z up, drawn out by width / 2 to
// both sides along y.
ConvexPolyhedron makePrism(const Eigen::Isometry3d& pose, const std::vector<Eigen::Vector2d>& profile, double width);

}  // namespace atom_map
