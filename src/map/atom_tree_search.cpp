#include <algorithm>
#include <cmath>

#include "atom_mapping/map/atom_tree.h"

namespace atom_map {
namespace {

void keepNearest(std::vector<Neighbor>& best, std::size_t k, const Neighbor& neighbor) {
  if (best.size() == k) best.pop_back();
  const auto farther = std::upper_bound(best.begin(), best.end(), neighbor, [](const Neighbor& a, const Neighbor& b) {
    return a.squared_distance < b.squared_distance;
  });
  best.insert(farther, neighbor);
}

}  // namespace

AtomTree::Split AtomTree::splitAt(const Inner& node, const Eigen::Vector3f& p) const {
  const float plane = node.plane;
  const float offset = p[node.axis] - plane;
  const std::size_t near = offset >= 0.0F ? 1 : 0;
  return {node.children[near], node.children[1 - near], std::max(0.0F, std::abs(offset) - kRounding * std::abs(plane))};
}

bool AtomTree::isAnyWithin(const Eigen::Vector3f& p, float radius) const {
  return size_ > 0 && isAnyBelow(root_, p, radius * radius, Gap());
}

bool AtomTree::isAnyBelow(Child child, const Eigen::Vector3f& p, float squared_radius, Gap gap) const {
  while (!isLeaf(child)) {
    const Inner& node = inner(child);
    const Split split = splitAt(node, p);
    if (gap.squaredBeyond(node.axis, split.distance) < squared_radius) {
      if (isAnyBelow(split.far, p, squared_radius, gap.beyond(node.axis, split.distance))) return true;
    }
    child = split.near;
  }
  bool is_any = false;
  forEachNear(leaf(child), p, squared_radius, [&](std::uint32_t, float) { is_any = true; });
  return is_any;
}

std::optional<Neighbor> AtomTree::nearest(const Eigen::Vector3f& p, float max_distance) const {
  std::vector<Neighbor> best;
  kNearest(p, 1, max_distance, best);
  return best.empty() ? std::nullopt : std::make_optional(best.front());
}

void AtomTree::kNearest(const Eigen::Vector3f& p, std::size_t k, float max_distance,
                        std::vector<Neighbor>& neighbors) const {
  neighbors.clear();
  if (size_ > 0 && k > 0) kNearestBelow(root_, p, k, max_distance * max_distance, Gap(), neighbors);
}

void AtomTree::kNearestBelow(Child child, const Eigen::Vector3f& p, std::size_t k, float max_squared_distance,
                             const Gap& gap, std::vector<Neighbor>& best) const {
  const auto bound = [&] { return best.size() == k ? best.back().squared_distance : max_squared_distance; };
  if (isLeaf(child)) {
    const AtomBlock& block = leaf(child);
    forEachNear(block, p, bound(), [&](std::uint32_t i, float squared_distance) {
      if (squared_distance >= bound()) return;
      Neighbor neighbor{block.center(i), squared_distance, {}};
      for (int v = 0; v < value_count_; ++v) neighbor.values[static_cast<std::size_t>(v)] = block.channel(3 + v)[i];
      keepNearest(best, k, neighbor);
    });
    return;
  }
  const Inner& node = inner(child);
  const Split split = splitAt(node, p);
  kNearestBelow(split.near, p, k, max_squared_distance, gap, best);
  if (gap.squaredBeyond(node.axis, split.distance) >= bound()) return;
  kNearestBelow(split.far, p, k, max_squared_distance, gap.beyond(node.axis, split.distance), best);
}

}  // namespace atom_map
