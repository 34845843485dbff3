#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "atom_mapping/base/types.h"

namespace atom_map {

// A scan's surface points in a tree of tight boxes, built at once. Around points that lie on surfaces the boxes are
// flat, so that a sphere in front of a surface meets few of them, where it would meet many cells of a k-d tree.
class PointBoxes {
 public:
  // O(n log n) for points as scans have them.
  explicit PointBoxes(const std::vector<SurfacePoint>& surface);

  // Whether any point lies nearer to p than `radius`.
  bool isAnyWithin(const Eigen::Vector3f& p, float radius) const;

 private:
  static constexpr std::ptrdiff_t kLeafSize = 16;  // points, unless they coincide

  // A node's points, their box and its children, `first_child` and the one after it; 0: a leaf.
  struct Node {
    Eigen::AlignedBox3f box;
    Eigen::Vector3f* begin;
    Eigen::Vector3f* end;
    std::size_t first_child = 0;
  };

  void add(Eigen::Vector3f* begin, Eigen::Vector3f* end);
  void split(std::size_t node);
  bool isAnyBelow(const Node& node, const Eigen::Vector3f& p, float squared_radius) const;

  std::vector<Eigen::Vector3f> points_;
  std::vector<Node> nodes_;  // the root first
};

}  // namespace atom_map
