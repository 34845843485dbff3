#include "atom_mapping/scan/point_boxes.h"

#include <cstring>
#include <limits>
#include <utility>

namespace atom_map {

PointBoxes::PointBoxes(const std::vector<SurfacePoint>& surface) {
  Points points;
  points.reserve(surface.size());
  for (const SurfacePoint& point : surface) {
    points.push_back(Floats{point.position.x(), point.position.y(), point.position.z(), 0.0F});
  }
  nodes_.reserve(surface.size() / kLeafSize + 1);
  add(points, {0, static_cast<std::uint32_t>(points.size())});
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    coordinates_[axis].reserve(points.size() + kLane);
    for (const Floats& point : points) coordinates_[axis].push_back(point[axis]);
    coordinates_[axis].resize(points.size() + kLane, std::numeric_limits<float>::infinity());
  }
}

PointBoxes::Box PointBoxes::boxOf(const Points& points, const Range& range) {
  const Floats infinite = Floats{} + std::numeric_limits<float>::infinity();
  Box box{infinite, -infinite};
  for (std::uint32_t i = range.begin; i < range.end; ++i) {
    const Floats& point = points[i];
    box.min = point < box.min ? point : box.min;
    box.max = point > box.max ? point : box.max;
  }
  return box;
}

// Two halves, at the middle of the box's longest side: that takes one pass, where to find the median takes several. Returns
// where the second begins. Without branches: on which side a point lies is hard to foretell.
std::uint32_t PointBoxes::divide(Points& points, const Range& range) {
  if (range.end - range.begin <= kLeafSize) return range.end;
  const Box box = boxOf(points, range);
  const Floats sides = box.max - box.min;
  std::uint32_t axis = sides[1] > sides[0] ? 1 : 0;
  if (sides[2] > sides[axis]) axis = 2;
  const float middle = 0.5F * (box.min[axis] + box.max[axis]);
  std::uint32_t above = range.begin;
  for (std::uint32_t i = range.begin; i < range.end; ++i) {
    const bool is_below = points[i][axis] < middle;
    std::swap(points[i], points[above]);
    above += is_below ? 1 : 0;
  }
  return above;
}

std::uint32_t PointBoxes::add(Points& points, const Range& range) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  const std::uint32_t middle = divide(points, range);
  const std::uint32_t first = divide(points, {range.begin, middle});
  const std::uint32_t third = divide(points, {middle, range.end});
  const std::array<Range, kLane> quarters{{{range.begin, first}, {first, middle}, {middle, third}, {third, range.end}}};
  nodes_[index].ranges = quarters;
  for (std::uint32_t i = 0; i < kLane; ++i) {
    const Range& quarter = quarters[i];
    const Box box = boxOf(points, quarter);
    nodes_[index].boxes.set(i, box.min, box.max);
    const std::uint32_t size = quarter.end - quarter.begin;
    const bool coincide = size == range.end - range.begin;
    if (size <= kLeafSize || coincide) continue;
    const std::uint32_t child = add(points, quarter);
    nodes_[index].children[i] = child;
  }
  return index;
}

bool PointBoxes::isAnyBelow(std::uint32_t node, const Eigen::Vector3f& p, float squared_radius) const {
  const Node& at = nodes_[node];
  const Bits within = at.boxes.squaredDistances(p) < squared_radius;
  for (std::uint32_t i = 0; i < kLane; ++i) {
    if (within[i] == 0) continue;
    const std::uint32_t child = at.children[i];
    if (child != 0 ? isAnyBelow(child, p, squared_radius) : isAnyIn(at.ranges[i], p, squared_radius)) return true;
  }
  return false;
}

// Whole lanes: the points beyond the range's end are points of the scan as well.
bool PointBoxes::isAnyIn(const Range& range, const Eigen::Vector3f& p, float squared_radius) const {
  Bits near{};
  for (std::uint32_t i = range.begin; i < range.end; i += kLane) {
    Floats squared{};
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      Floats coordinate;
      std::memcpy(&coordinate, coordinates_[axis].data() + i, sizeof coordinate);
      const Floats offset = coordinate - p[axis];
      squared += offset * offset;
    }
    near |= squared < squared_radius;
  }
  return unionOf(near) != 0;
}

}  // namespace atom_map
