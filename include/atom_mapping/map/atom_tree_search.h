// Searches of AtomTree that call a visitor; included by atom_tree.h only.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "atom_mapping/map/atom_tree.h"

namespace atom_map {

// Calls visit(leaf's child reference) for each leaf whose side of every split meets the closed box.
template <class Visit>
void AtomTree::visitLeaves(const Eigen::AlignedBox3f& box, Visit&& visit) const {
  if (size_ == 0) return;
  std::array<Child, kMaxDepth> waiting;
  std::size_t count = 0;
  for (Child child = root_;; child = waiting[--count]) {
    while (!isLeaf(child)) {
      const Inner& node = inner(child);
      const bool below = box.min()[node.axis] < node.plane;
      const bool above = box.max()[node.axis] >= node.plane;
      if (below && above) waiting[count++] = node.children[1];
      child = node.children[below ? 0 : 1];
    }
    visit(child);
    if (count == 0) return;
  }
}

// Calls visit(block) for each leaf that find_leaves(found) calls found(child) for, in that order, but some leaves later:
// most of a search in a large map is waiting for memory.
template <class FindLeaves, class Visit>
void AtomTree::visitPrefetched(const FindLeaves& find_leaves, const Visit& visit) const {
  constexpr std::size_t kAhead = 8;
  std::array<Child, kAhead> waiting{};
  std::size_t found = 0;
  find_leaves([&](Child child) {
    leaf(child).prefetch();
    if (found >= kAhead) visit(leaf(waiting[found % kAhead]));
    waiting[found++ % kAhead] = child;
  });
  for (std::size_t i = found - std::min(found, kAhead); i < found; ++i) visit(leaf(waiting[i % kAhead]));
}

// Calls visit(leaf's child reference) for each leaf whose box comes nearer to p than the radius. `squared_radius`: widened.
template <class Visit>
void AtomTree::visitLeavesWithin(Child child, const Eigen::Vector3f& p, float squared_radius, const GapToBox& gap,
                                 Visit&& visit) const {
  while (!isLeaf(child)) {
    const Inner& node = inner(child);
    const float offset = p[node.axis] - node.plane;
    const bool is_above = offset >= 0.0F;
    if (gap.squaredBeyond(node.axis, offset) >= squared_radius) {
      child = node.children[is_above ? 1 : 0];
      continue;
    }
    const GapToBox beyond = gap.beyond(node.axis, offset);
    visitLeavesWithin(node.children[0], p, squared_radius, is_above ? beyond : gap, visit);
    visitLeavesWithin(node.children[1], p, squared_radius, is_above ? gap : beyond, visit);
    return;
  }
  visit(child);
}

template <class Visit>
void AtomTree::forEachNear(const AtomBlock& block, const Eigen::Vector3f& p, float squared_radius, Visit&& visit) {
  for (std::uint32_t first = 0; first < block.size(); first += AtomBlock::kMaskSize) {
    for (std::uint32_t mask = block.nearMask(p, squared_radius, first); mask != 0; mask &= mask - 1) {
      const std::uint32_t i = first + static_cast<std::uint32_t>(__builtin_ctz(mask));
      visit(i, block.squaredDistance(i, p));
    }
  }
}

template <class Visit>
void AtomTree::forEachWithin(const Eigen::Vector3f& p, float radius, Visit&& visit, AtomBlock::Signs signs) const {
  if (size_ == 0) return;
  const float squared_radius = radius * radius;
  const float widened = widenedAt(p, radius);
  const auto find_leaves = [&](const auto& found) {
    visitLeavesWithin(root_, p, widened * widened, GapToBox(), [&](Child child) {
      if (leaf(child).mayHold(signs)) found(child);
    });
  };
  visitPrefetched(find_leaves, [&](const AtomBlock& block) {
    forEachNear(block, p, squared_radius, [&](std::uint32_t i, float squared_distance) {
      visit(ConstAtomRef{&block, i}, squared_distance);
    });
  });
}

// Calls visit(leaf's child reference) for each leaf whose side of every split comes nearer to the way than its radius. Of the
// way from share `begin` to share `end`, each side gets what is near to it.
template <class Visit>
void AtomTree::visitLeavesAlong(Child child, const CutWay& way, float begin, float end, Visit&& visit) const {
  while (!isLeaf(child)) {
    const Inner& node = inner(child);
    const CutWay::Axis& axis = way.axes[node.axis];
    const float crossing = (node.plane - axis.start) * axis.shares_per_metre;
    const bool meets_first = begin < crossing + axis.reach;
    const bool meets_second = end >= crossing - axis.reach;
    const std::size_t first = axis.shares_per_metre < 0.0F ? 1 : 0;
    if (meets_first && meets_second) {
      visitLeavesAlong(node.children[first], way, begin, std::min(end, crossing + axis.reach), visit);
      begin = std::max(begin, crossing - axis.reach);
    }
    child = node.children[meets_second ? 1 - first : first];
  }
  visit(child);
}

template <class Visit>
void AtomTree::forEachAlong(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius, Visit&& visit) const {
  if (size_ == 0) return;
  const Eigen::Vector3f way = to - from;
  const float squared_length = way.squaredNorm();
  const Eigen::Vector3f to_share = squared_length > 0.0F ? Eigen::Vector3f(way / squared_length) : way;
  const float squared_radius = radius * radius;
  const CutWay cut(from, to, radius);
  const auto find_leaves = [&](const auto& found) { visitLeavesAlong(root_, cut, 0.0F, 1.0F, found); };
  visitPrefetched(find_leaves, [&](const AtomBlock& block) {
    for (std::uint32_t first = 0; first < block.size(); first += AtomBlock::kMaskSize) {
      for (std::uint32_t mask = block.nearMask(from, way, to_share, squared_radius, first); mask != 0;
           mask &= mask - 1) {
        visit(ConstAtomRef{&block, first + static_cast<std::uint32_t>(__builtin_ctz(mask))});
      }
    }
  });
}

template <class Visit>
void AtomTree::forEachInBox(const Eigen::AlignedBox3f& box, Visit&& visit) const {
  if (box.isEmpty()) return;
  visitLeaves(box, [&](Child child) {
    const AtomBlock& block = leaf(child);
    for (std::uint32_t i = 0; i < block.size(); ++i) {
      if (box.contains(block.center(i))) visit(ConstAtomRef{&block, i});
    }
  });
}

template <class Visit>
void AtomTree::forEachLeaf(const Eigen::AlignedBox3f& box, LeafSearch& search, Visit&& visit) {
  findLeaves(box, search);
  for (std::size_t i = 0; i < search.leaf_count_; ++i) {
    const LeafSearch::Node& found = search.leaves_[i];
    visit(leaf(found.child), found.min, found.max);
  }
}

template <class Visit>
void AtomTree::forEachBlock(Visit&& visit) const {
  constexpr float kAll = std::numeric_limits<float>::max();
  visitLeaves({Eigen::Vector3f::Constant(-kAll), Eigen::Vector3f::Constant(kAll)},
              [&](Child child) { visit(leaf(child)); });
}

template <class Visit>
void AtomTree::forEach(Visit&& visit) const {
  forEachBlock([&](const AtomBlock& block) {
    for (std::uint32_t i = 0; i < block.size(); ++i) visit(ConstAtomRef{&block, i});
  });
}

}  // namespace atom_map
