#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "atom_mapping/base/types.h"

namespace atom_map {

// A scan's surface points in a balanced tree of tight boxes, built at once. Around points that lie on surfaces the boxes are
// flat, so that a sphere in front of a surface meets few of them, where it would meet many cells of a k-d tree.
class PointBoxes {
 public:
  // O(n log n).
  explicit PointBoxes(const std::vector<SurfacePoint>& surface);

  // Whether any point lies nearer to p than `radius`.
  bool isAnyWithin(const Eigen::Vector3f& p, float radius) const;

 private:
  static constexpr std::size_t kLeafSize = 16;  // points

  void build(std::size_t node, Eigen::Vector3f* begin, Eigen::Vector3f* end);
  bool isAnyBelow(std::size_t node, const Eigen::Vector3f& p, float squared_radius) const;

  // A node's points, its box and, unless it is a leaf, its children 2 node and 2 node + 1; the root is node 1.
  struct Node {
    Eigen::AlignedBox3f box;
    const Eigen::Vector3f* begin;
    const Eigen::Vector3f* end;
  };
  std::vector<Eigen::Vector3f> points_;
  std::vector<Node> nodes_;
  std::size_t leaves_ = 1;  // a power of two; they are the last nodes
};

}  // namespace atom_map
