#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "atom_mapping/base/four_boxes.h"
#include "atom_mapping/base/types.h"

namespace atom_map {

// A scan's surface points in a tree of tight boxes, four to a node, built at once. Around points that lie on surfaces the
// boxes are flat, so that a sphere in front of a surface meets few of them, where it would meet many cells of a k-d tree.
class PointBoxes {
 public:
  // O(n log n) for points as scans have them.
  explicit PointBoxes(const std::vector<SurfacePoint>& surface);

  // Whether any point lies nearer to p than `radius`.
  bool isAnyWithin(const Eigen::Vector3f& p, float radius) const { return isAnyBelow(0, p, radius * radius); }

 private:
  static constexpr std::uint32_t kLeafSize = 16;  // points, unless they coincide

  struct Range {  // of points
    std::uint32_t begin;
    std::uint32_t end;
  };
  struct Box {
    Floats min;
    Floats max;
  };
  struct Node {
    FourBoxes boxes;
    std::array<Range, kLane> ranges{};            // of the points in each
    std::array<std::uint32_t, kLane> children{};  // the node that divides them further; 0: none
  };

  using Points = std::vector<Floats>;  // x, y, z, 0

  static Box boxOf(const Points& points, const Range& range);
  static std::uint32_t divide(Points& points, const Range& range);
  std::uint32_t add(Points& points, const Range& range);
  bool isAnyBelow(std::uint32_t node, const Eigen::Vector3f& p, float squared_radius) const;
  bool isAnyIn(const Range& range, const Eigen::Vector3f& p, float squared_radius) const;

  std::array<std::vector<float>, 3> coordinates_;  // of the points, by axes; after the last, a lane that is nowhere
  std::vector<Node> nodes_;                        // the root first
};

}  // namespace atom_map
