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

// Calls visit(leaf's child reference) for each leaf whose box comes nearer to p than the radius.
template <class Visit>
void AtomTree::visitLeavesWithin(Child child, const Eigen::Vector3f& p, float squared_radius, Gap gap,
                                 Visit&& visit) const {
  while (!isLeaf(child)) {
    const Inner& node = inner(child);
    const float plane = node.plane;
    const float offset = p[node.axis] - plane;
    const bool is_above = offset >= 0.0F;
    const float distance = std::max(0.0F, std::abs(offset) - kRounding * std::abs(plane));
    if (gap.squaredBeyond(node.axis, distance) >= squared_radius) {
      child = node.children[is_above ? 1 : 0];
      continue;
    }
    const Gap beyond = gap.beyond(node.axis, distance);
    visitLeavesWithin(node.children[0], p, squared_radius, is_above ? beyond : gap, visit);
    if (!is_above) gap = beyond;
    child = node.children[1];
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
void AtomTree::forEachWithin(const Eigen::Vector3f& p, float radius, Visit&& visit) const {
  if (size_ == 0) return;
  const float squared_radius = radius * radius;
  const auto find_leaves = [&](const auto& found) { visitLeavesWithin(root_, p, squared_radius, Gap(), found); };
  visitPrefetched(find_leaves, [&](const AtomBlock& block) {
    forEachNear(block, p, squared_radius, [&](std::uint32_t i, float squared_distance) {
      visit(ConstAtomRef{&block, i}, squared_distance);
    });
  });
}

// Calls visit(leaf's child reference) for each leaf whose side of every split comes nearer to the part than `radius`. Of
// the part, each side gets what is near to it.
template <class Visit>
void AtomTree::visitLeavesAlong(Child child, Segment part, float radius, Visit&& visit) const {
  while (!isLeaf(child)) {
    const Inner& node = inner(child);
    const float plane = node.plane;
    const float way = part.way[node.axis];
    const float reach = radius + 4.0F * kRounding * (std::abs(plane) + radius + std::abs(way));
    const float begin = part.coordinate(node.axis, part.begin) - plane;
    const float end = part.coordinate(node.axis, part.end) - plane;
    const bool below = std::min(begin, end) < reach;
    const bool above = std::max(begin, end) >= -reach;
    if (below && above) {
      const auto share_at = [&](float offset) { return (plane + offset - part.start[node.axis]) / way; };
      Segment lower = part;
      if (end > reach) lower.end = share_at(reach);
      if (begin > reach) lower.begin = share_at(reach);
      if (begin < -reach) part.begin = share_at(-reach);
      if (end < -reach) part.end = share_at(-reach);
      visitLeavesAlong(node.children[0], lower, radius, visit);
    }
    child = node.children[above ? 1 : 0];
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
  const Segment whole{from, way, 0.0F, 1.0F};
  const auto find_leaves = [&](const auto& found) { visitLeavesAlong(root_, whole, radius, found); };
  visitPrefetched(find_leaves, [&](const AtomBlock& block) {
    const float* x = block.channel(0);
    const float* y = block.channel(1);
    const float* z = block.channel(2);
    std::array<float, AtomBlock::kLane> squared{};
    for (std::uint32_t lane = 0; lane < block.size(); lane += AtomBlock::kLane) {
      for (std::uint32_t i = 0; i < AtomBlock::kLane; ++i) {
        const float dx = x[lane + i] - from.x();
        const float dy = y[lane + i] - from.y();
        const float dz = z[lane + i] - from.z();
        const float along = dx * to_share.x() + dy * to_share.y() + dz * to_share.z();
        const float share = std::min(std::max(along, 0.0F), 1.0F);
        const float off_x = dx - share * way.x();
        const float off_y = dy - share * way.y();
        const float off_z = dz - share * way.z();
        squared[i] = off_x * off_x + off_y * off_y + off_z * off_z;
      }
      for (std::uint32_t i = 0; i < AtomBlock::kLane; ++i) {
        if (squared[i] < squared_radius) visit(ConstAtomRef{&block, lane + i});
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
void AtomTree::forEachLeaf(const Eigen::AlignedBox3f& box, Visit&& visit) {
  if (size_ == 0) return;
  constexpr float kAll = std::numeric_limits<float>::infinity();
  visitBoxes(root_, box, {Eigen::Vector3f::Constant(-kAll), Eigen::Vector3f::Constant(kAll)}, visit);
}

template <class Visit>
void AtomTree::visitBoxes(Child child, const Eigen::AlignedBox3f& box, Eigen::AlignedBox3f bounds, Visit&& visit) {
  while (!isLeaf(child)) {
    const Inner& node = inner(child);
    const bool below = box.min()[node.axis] < node.plane;
    const bool above = box.max()[node.axis] >= node.plane;
    if (below && above) {
      Eigen::AlignedBox3f lower = bounds;
      lower.max()[node.axis] = node.plane;
      visitBoxes(node.children[0], box, lower, visit);
    }
    if (above) bounds.min()[node.axis] = node.plane;
    if (!above) bounds.max()[node.axis] = node.plane;
    child = node.children[above ? 1 : 0];
  }
  visit(leaf(child), bounds);
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
