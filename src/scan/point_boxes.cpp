#include "atom_mapping/scan/point_boxes.h"

#include <algorithm>

namespace atom_map {

PointBoxes::PointBoxes(const std::vector<SurfacePoint>& surface) {
  points_.reserve(surface.size());
  for (const SurfacePoint& point : surface) points_.push_back(point.position);
  nodes_.reserve(surface.size() / 4 + 1);
  add(points_.data(), points_.data() + points_.size());
  for (std::size_t node = 0; node < nodes_.size(); ++node) split(node);
}

void PointBoxes::add(Eigen::Vector3f* begin, Eigen::Vector3f* end) {
  Eigen::AlignedBox3f box;
  std::for_each(begin, end, [&](const Eigen::Vector3f& point) { box.extend(point); });
  nodes_.push_back({box, begin, end});
}

// At the middle of the longest side: that takes one pass, where to find the median takes several.
void PointBoxes::split(std::size_t node) {
  const auto [box, begin, end, none] = nodes_[node];
  if (end - begin <= kLeafSize) return;
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const float middle = box.center()[axis];
  Eigen::Vector3f* const above =
      std::partition(begin, end, [axis = axis, middle](const auto& point) { return point[axis] < middle; });
  if (above == begin || above == end) return;  // they coincide
  nodes_[node].first_child = nodes_.size();
  add(begin, above);
  add(above, end);
}

bool PointBoxes::isAnyWithin(const Eigen::Vector3f& p, float radius) const {
  return isAnyBelow(nodes_.front(), p, radius * radius);
}

bool PointBoxes::isAnyBelow(const Node& node, const Eigen::Vector3f& p, float squared_radius) const {
  if (node.first_child == 0) {
    return std::any_of(node.begin, node.end, [&](const auto& q) { return (q - p).squaredNorm() < squared_radius; });
  }
  const Node* nearer = &nodes_[node.first_child];
  const Node* farther = nearer + 1;
  float least = nearer->box.squaredExteriorDistance(p);
  float greatest = farther->box.squaredExteriorDistance(p);
  if (greatest < least) {
    std::swap(nearer, farther);
    std::swap(least, greatest);
  }
  if (least < squared_radius && isAnyBelow(*nearer, p, squared_radius)) return true;
  return greatest < squared_radius && isAnyBelow(*farther, p, squared_radius);
}

}  // namespace atom_map
