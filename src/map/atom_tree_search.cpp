#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "atom_mapping/map/atom_tree.h"

namespace atom_map {

// Level by level, so that a node has come from memory by the time that it is looked at, and without branches: which nodes a
// box meets is hard to foretell.
void AtomTree::findLeaves(const Eigen::AlignedBox3f& box, LeafSearch& search) {
  using Node = LeafSearch::Node;
  search.leaf_count_ = 0;
  if (size_ == 0) return;
  static constexpr std::array<Bits, 3> kAxis{Bits{-1, 0, 0, 0}, Bits{0, -1, 0, 0}, Bits{0, 0, -1, 0}};
  std::size_t end = 0;  // of those that wait
  const auto make_room = [](std::vector<Node>& nodes, std::size_t used) {
    if (used + 2 > nodes.size()) nodes.resize(2 * used + 64);
  };
  const auto add = [&](const Node& node, bool meets) {
    const bool is_leaf = isLeaf(node.child);
    __builtin_prefetch(is_leaf ? static_cast<const void*>(&leaf(node.child)) : &inner(node.child));
    (is_leaf ? search.leaves_[search.leaf_count_] : search.waiting_[end]) = node;
    search.leaf_count_ += is_leaf && meets ? 1 : 0;
    end += !is_leaf && meets ? 1 : 0;
  };
  make_room(search.waiting_, end);
  make_room(search.leaves_, search.leaf_count_);
  const Floats all = Floats{} + std::numeric_limits<float>::infinity();
  add({-all, all, root_}, true);
  for (std::size_t begin = 0; begin < end; ++begin) {
    make_room(search.waiting_, end);
    make_room(search.leaves_, search.leaf_count_);
    const Node at = search.waiting_[begin];
    const Inner& node = inner(at.child);
    const Floats plane = Floats{} + node.plane;
    const Bits axis = kAxis[node.axis];
    add({at.min, axis ? plane : at.max, node.children[0]}, box.min()[node.axis] < node.plane);
    add({axis ? plane : at.min, at.max, node.children[1]}, box.max()[node.axis] >= node.plane);
  }
}

namespace {

void keepNearest(std::vector<Neighbor>& best, std::size_t k, const Neighbor& neighbor) {
  if (best.size() == k) best.pop_back();
  const auto farther = std::upper_bound(best.begin(), best.end(), neighbor, [](const Neighbor& a, const Neighbor& b) {
    return a.squared_distance < b.squared_distance;
  });
  best.insert(farther, neighbor);
}

}  // namespace

// Of a radius about p, with the rounding of what is compared with planes so near.
float AtomTree::widenedAt(const Eigen::Vector3f& p, float radius) {
  return radius + 2.0F * kTreeRounding * (p.cwiseAbs().maxCoeff() + radius);
}

AtomTree::Split AtomTree::splitAt(const Inner& node, const Eigen::Vector3f& p) const {
  const float plane = node.plane;
  const float offset = p[node.axis] - plane;
  const std::size_t near = offset >= 0.0F ? 1 : 0;
  return {node.children[near], node.children[1 - near],
          std::max(0.0F, std::abs(offset) - kTreeRounding * std::abs(plane))};
}

std::optional<Eigen::Vector3f> AtomTree::anyWithin(const Eigen::Vector3f& p, float radius) const {
  return size_ > 0 ? anyBelow(root_, p, radius * radius, GapToBox()) : std::nullopt;
}

std::optional<Eigen::Vector3f> AtomTree::anyBelow(Child child, const Eigen::Vector3f& p, float squared_radius,
                                                  const GapToBox& gap) const {
  if (isLeaf(child)) {
    const AtomBlock& block = leaf(child);
    std::optional<Eigen::Vector3f> found;
    forEachNear(block, p, squared_radius, [&](std::uint32_t i, float) { found = block.center(i); });
    return found;
  }
  const Inner& node = inner(child);
  const Split split = splitAt(node, p);
  if (const auto found = anyBelow(split.near, p, squared_radius, gap)) return found;
  const GapToBox beyond = gap.beyond(node.axis, split.distance);
  return beyond.squared < squared_radius ? anyBelow(split.far, p, squared_radius, beyond) : std::nullopt;
}

std::optional<Neighbor> AtomTree::nearest(const Eigen::Vector3f& p, float max_distance) const {
  std::vector<Neighbor> best;
  kNearest(p, 1, max_distance, best);
  return best.empty() ? std::nullopt : std::make_optional(best.front());
}

void AtomTree::kNearest(const Eigen::Vector3f& p, std::size_t k, float max_distance,
                        std::vector<Neighbor>& neighbors) const {
  neighbors.clear();
  if (size_ > 0 && k > 0) kNearestBelow(root_, p, k, max_distance * max_distance, GapToBox(), neighbors);
}

void AtomTree::kNearestBelow(Child child, const Eigen::Vector3f& p, std::size_t k, float max_squared_distance,
                             const GapToBox& gap, std::vector<Neighbor>& best) const {
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
  const GapToBox beyond = gap.beyond(node.axis, split.distance);
  if (beyond.squared < bound()) kNearestBelow(split.far, p, k, max_squared_distance, beyond, best);
}

}  // namespace atom_map
