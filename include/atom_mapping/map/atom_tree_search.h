// Searches of AtomTree that call a visitor; included by atom_tree.h only.
#pragma once

#include <utility>

#include "atom_mapping/map/atom_tree.h"

namespace atom_map {

// Calls visit(leaf's child reference) for each leaf whose side of every split meets the range.
template <class Visit>
void AtomTree::visitLeaves(Child child, const CellRange& range, Visit&& visit) const {
  while (!isLeaf(child)) {
    const Inner& node = inner(child);
    const bool below = range.low[node.axis] < node.plane;
    const bool above = range.high[node.axis] >= node.plane;
    if (below && above) visitLeaves(node.children[0], range, visit);
    child = node.children[above ? 1 : 0];
  }
  visit(child);
}

template <class Visit>
void AtomTree::forEachWithin(const Eigen::Vector3f& p, float radius, Visit&& visit) {
  std::as_const(*this).forEachWithin(p, radius, [&](ConstAtomRef atom, float squared_distance) {
    visit(AtomRef{const_cast<AtomBlock*>(atom.block), atom.index}, squared_distance);
  });
}

template <class Visit>
void AtomTree::forEachWithin(const Eigen::Vector3f& p, float radius, Visit&& visit) const {
  if (size_ == 0) return;
  const Eigen::Vector3f reach = Eigen::Vector3f::Constant(radius);
  const float squared_radius = radius * radius;
  using Lane = AtomBlock::Lane;
  visitLeaves(root_, keysOf({p - reach, p + reach}), [&](Child child) {
    const AtomBlock& block = leaf(child);
    for (std::uint32_t lane = 0; lane < block.size(); lane += AtomBlock::kLane) {
      const Lane squared = (block.lane(0, lane) - p.x()).square() + (block.lane(1, lane) - p.y()).square() +
                           (block.lane(2, lane) - p.z()).square();
      if (squared.minCoeff() >= squared_radius) continue;
      for (std::uint32_t i = 0; i < AtomBlock::kLane; ++i) {
        if (squared[i] < squared_radius) visit(ConstAtomRef{&block, lane + i}, squared[i]);
      }
    }
  });
}

template <class Visit>
void AtomTree::forEachInBox(const Eigen::AlignedBox3f& box, Visit&& visit) const {
  if (size_ == 0 || box.isEmpty()) return;
  visitLeaves(root_, keysOf(box), [&](Child child) {
    const AtomBlock& block = leaf(child);
    for (std::uint32_t i = 0; i < block.size(); ++i) {
      if (box.contains(block.center(i))) visit(ConstAtomRef{&block, i});
    }
  });
}

template <class Visit>
void AtomTree::forEachBlock(Visit&& visit) const {
  if (size_ == 0) return;
  constexpr std::uint32_t kEnd = ~0U;
  visitLeaves(root_, {{0, 0, 0}, {kEnd, kEnd, kEnd}}, [&](Child child) { visit(leaf(child)); });
}

template <class Visit>
void AtomTree::forEach(Visit&& visit) const {
  forEachBlock([&](const AtomBlock& block) {
    for (std::uint32_t i = 0; i < block.size(); ++i) visit(ConstAtomRef{&block, i});
  });
}

}  // namespace atom_map
