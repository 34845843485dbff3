// The map: equal spheres that do not overlap, each with what it stores (paper III-A, III-B).
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "atom_mapping/base/known_plane.h"
#include "atom_mapping/base/parameters.h"
#include "atom_mapping/base/types.h"
#include "atom_mapping/map/atom_tree.h"

namespace atom_map {

class AtomMap {
 public:
  // Choice: atoms nearer than this share of a diameter overlap. Without the tolerance, rounding would make half of the
  // tangent atoms along a ray overlap their neighbours, and leave holes.
  static constexpr float kOverlapTolerance = 0.999F;

  // `radius` in metres, of every atom.
  AtomMap(Mode mode, double radius);

  Mode mode() const { return mode_; }
  float radius() const { return radius_; }

  // Choice: atoms lie in single precision in a local frame, parallel to the map frame, so that a map far from its
  // frame's origin (UTM) loses nothing. Its origin, in the map frame, follows from the first scan.
  const Eigen::Vector3d& origin() const { return origin_; }
  // Sets the origin to the point's whole metres; nothing once the map holds atoms. `point` in the map frame.
  void anchor(const Eigen::Vector3d& point);
  Eigen::Vector3f toLocal(const Eigen::Vector3d& point) const { return (point - origin_).cast<float>(); }
  Eigen::Vector3d toMap(const Eigen::Vector3f& point) const { return point.cast<double>() + origin_; }

  // Atoms in the local frame. Value 0 is the log-odds of occupancy, or the signed distance (m) with value 1 its
  // variance (m^2).
  const AtomTree& atoms() const { return atoms_; }
  AtomTree& atoms() { return atoms_; }

  // What the last scan found of flat surfaces, for the next one: see estimateSurface.
  const std::vector<KnownPlane>& planes() const { return planes_; }
  std::vector<KnownPlane>& planes() { return planes_; }

  // Removes the atoms whose centres lie in the closed box of the map frame; returns how many.
  std::size_t clearRegion(const Eigen::AlignedBox3d& box);
  void reset();

 private:
  Mode mode_;
  float radius_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  AtomTree atoms_;
  std::vector<KnownPlane> planes_;
};

}  // namespace atom_map
