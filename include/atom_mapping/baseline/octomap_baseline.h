// The map that users compare with: liboctomap, fed with the same returns (paper V-B).
#pragma once

#include <octomap/OcTree.h>

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "atom_mapping/base/types.h"
#include "atom_mapping/query/occupancy.h"

namespace atom_map {

// Side of the cubic voxel that holds as much as an atom: r (4 pi / 3)^(1/3). Metres.
double equalVolumeVoxel(double radius);

octomap::point3d toOctomap(const Eigen::Vector3d& point);

class OctomapBaseline {
 public:
  // OctoMap's own defaults (hit 0.7, miss 0.4, clamps 0.12 and 0.97), depth 16. `resolution`: side of a voxel, m.
  // Without pruning no node is ever joined (the paper's setting); with it, equal ones are joined at each update, as in
  // octomap_server.
  explicit OctomapBaseline(double resolution, bool prune = false);

  // Merges the returns of one scan, in the sensor's frame; a return beyond `max_range`, unless that is negative, only
  // frees the space up to it. `sensor`: sensor frame to map frame. What lies outside the tree's 2^16 voxels is left
  // out; returns how many were merged.
  std::size_t insertScan(const std::vector<Eigen::Vector3f>& returns, const Pose& sensor, double max_range = -1.0);

  // Of a point of the map frame, as the voxel around it says; nothing where there is none.
  std::optional<float> logOdds(const Eigen::Vector3d& point) const;
  Occupancy classify(const Eigen::Vector3d& point) const;

  // Whether a sphere of the map frame touches an occupied voxel or, unless unknown is free, reaches into space without
  // a voxel. Costs O((sphere's radius / voxel)^3) then.
  bool collides(const Eigen::Vector3d& center, double radius, bool unknown_is_free) const;

  // Heap bytes of the nodes, by the sizes that glibc's allocator gives them. Walks over the whole tree.
  std::size_t bytes() const;

  const octomap::OcTree& tree() const { return tree_; }
  octomap::OcTree& tree() { return tree_; }

 private:
  bool touchesOccupied(const Eigen::Vector3d& center, double radius) const;
  bool touchesUnknown(const Eigen::Vector3d& center, double radius) const;

  octomap::OcTree tree_;
  bool prune_;
};

}  // namespace atom_map
