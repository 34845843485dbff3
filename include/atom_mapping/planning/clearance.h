// Where a robot may be: the tests that every part of a planned path has passed.
#pragma once

#include <Eigen/Core>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/map/atom_map.h"
#include "atom_mapping/query/gaussian_process.h"

namespace atom_map {

// Of one path. Points in the map's local frame; lengths in metres.
struct SafetyRules {
  GaussianProcessParameters regression;  // of signed distances, in signed distance mode
  float robot_radius = 0.0F;
  float margin = 0.0F;  // that the radius grows by, away from the path's ends
  Eigen::Vector3f start = Eigen::Vector3f::Zero();
  Eigen::Vector3f goal = Eigen::Vector3f::Zero();
};

// A robot's sphere in a map. One object serves one thread, while the map stands still.
//
// Choice: everywhere the sphere keeps clear of occupied atoms (and keeps its radius by the regression, in signed distance
// mode), and its center to known space. Atoms leave out edges and what no ray saw by up to a radius and more; so, but for
// two radii about the path's ends, collides() must hold the sphere with its margin for safe too: also from what Eq. (5)
// calls occupied between atoms, and from unknown space as far as two radii from the center. Start and goal may thus lie
// anywhere, and a sphere larger than that may reach into unknown space, as between the rings of a VLP-16 it must.
class Clearance {
 public:
  // The map must outlive this.
  Clearance(const AtomMap& map, const SafetyRules& rules);

  // From a point to the nearest surface, at most `reach`: to the nearest occupied atom's center less r, since occupied
  // atoms are tangent to surfaces; in signed distance mode the estimate, where that is less. Negative in a surface.
  float surfaceDistance(const Eigen::Vector3f& point, float reach);
  // The same at an atom, which knows its own signed distance.
  float surfaceDistance(ConstAtomRef atom, float reach) const;

  // Whether the sphere is safe all the way between two points, save that the way must be known. Exact as to occupied
  // atoms; the rest is asked every half radius.
  bool isSafe(const Eigen::Vector3f& from, const Eigen::Vector3f& to);
  bool isSafe(const Eigen::Vector3f& point) { return isSafe(point, point); }

  // Whether the sphere keeps clear of occupied atoms all the way.
  bool isClear(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const;

  // Whether the regression leaves so much (m) to surfaces, in signed distance mode; true where it tells nothing.
  bool keepsDistance(const Eigen::Vector3f& point, float least);

  // Whether every point of the way lies less than two radii from an atom, as between atoms' centers less than four radii
  // apart it always does.
  bool isKnown(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const;

 private:
  float occupiedDistance(const Eigen::Vector3f& point, float reach) const;
  bool collidesAt(const Eigen::Vector3f& point) const;

  const AtomMap& map_;
  SafetyRules rules_;
  GaussianProcess distances_;
};

}  // namespace atom_map
