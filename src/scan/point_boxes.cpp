#include "atom_mapping/scan/point_boxes.h"

#include <algorithm>

namespace atom_map {

PointBoxes::PointBoxes(const std::vector<SurfacePoint>& surface) {
  points_.reserve(surface.size());
  for (const SurfacePoint& point : surface) points_.push_back(point.position);
  while (leaves_ * kLeafSize < points_.size()) leaves_ *= 2;
  nodes_.resize(2 * leaves_);
  build(1, points_.data(), points_.data() + points_.size());
}

void PointBoxes::build(std::size_t node, Eigen::Vector3f* begin, Eigen::Vector3f* end) {
  Eigen::AlignedBox3f box;
  std::for_each(begin, end, [&](const Eigen::Vector3f& point) { box.extend(point); });
  nodes_[node] = {box, begin, end};
  if (node >= leaves_) return;
  int axis = 0;
  if (begin != end) box.sizes().maxCoeff(&axis);
  Eigen::Vector3f* const middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
  build(2 * node, begin, middle);
  build(2 * node + 1, middle, end);
}

bool PointBoxes::isAnyWithin(const Eigen::Vector3f& p, float radius) const {
  return isAnyBelow(1, p, radius * radius);
}

bool PointBoxes::isAnyBelow(std::size_t node, const Eigen::Vector3f& p, float squared_radius) const {
  const Node& here = nodes_[node];
  if (node >= leaves_) {
    return std::any_of(here.begin, here.end, [&](const auto& q) { return (q - p).squaredNorm() < squared_radius; });
  }
  const float left = nodes_[2 * node].box.squaredExteriorDistance(p);
  const float right = nodes_[2 * node + 1].box.squaredExteriorDistance(p);
  const std::size_t nearer = left < right ? 2 * node : 2 * node + 1;
  if (std::min(left, right) < squared_radius && isAnyBelow(nearer, p, squared_radius)) return true;
  return std::max(left, right) < squared_radius && isAnyBelow(nearer ^ 1U, p, squared_radius);
}

}  // namespace atom_map
