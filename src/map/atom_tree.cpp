#include "atom_mapping/map/atom_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace atom_map {

AtomTree::AtomTree(float cell, int value_count)
    : cell_(std::exp2(std::floor(std::log2(cell)))), cells_per_metre_(1.0F / cell_), value_count_(value_count) {
  assert(cell > 0.0F && value_count >= 1 && value_count <= 2);
}

bool AtomTree::insert(const Eigen::Vector3f& center, const float* values) {
  ++size_;
  extent_.extend(center);
  if (size_ == 1) root_ = newLeaf();
  Place place{kRoot, 0};
  while (!isLeaf(at(place))) place = {at(place), inner(at(place)).side(center)};
  // All atoms beneath a node share every plane coarser than its own, so one of them speaks for all.
  const AtomBlock& reached = leaf(at(place));
  const int level = reached.size() == 0 ? -1 : CellKey::firstDifference(key(center), key(reached.center(0)));
  if (place.parent != kRoot && inner(place.parent).level < level) {
    // The atom lies outside of the box that holds all beneath a node on this way.
    place = {kRoot, 0};
    while (inner(at(place)).level > level) place = {at(place), inner(at(place)).side(center)};
    const Child lone = newLeaf();
    changeLeaf(lone, [&](AtomBlock& block) { block.push(center, values); });
    const Child parent = newInner(level, center, lone, at(place));
    at(place) = parent;
    return true;
  }
  changeLeaf(at(place), [&](AtomBlock& block) { block.push(center, values); });
  return splitIfOverfull(place) || size_ == 1 || leaf(at(place)).size() > kLeafCapacity;
}

// Each side keeps its atoms in their order, and so does a leaf made of two: a tree made of another's atoms, in that one's
// order, has the same order. Map files rely on it.
bool AtomTree::splitIfOverfull(Place place) {
  const Child one = at(place);
  if (leaf(one).size() <= kLeafCapacity) return false;
  const CellKey first = key(leaf(one).center(0));
  int level = -1;
  for (std::uint32_t i = 1; i < leaf(one).size(); ++i) {
    level = std::max(level, CellKey::firstDifference(first, key(leaf(one).center(i))));
  }
  if (level < 0) return false;
  const Child other = newLeaf();
  const AtomBlock atoms = taken(one);
  const Child parent = newInner(level, atoms.center(0), one, other);
  for (std::uint32_t i = 0; i < atoms.size(); ++i) {
    const Child side = inner(parent).children[inner(parent).side(atoms.center(i))];
    changeLeaf(side, [&](AtomBlock& block) { block.push(atoms, i); });
  }
  at(place) = parent;
  splitIfOverfull({parent, 0});
  splitIfOverfull({parent, 1});
  return true;
}

AtomTree::Child AtomTree::newLeaf() {
  if (free_leaves_.empty()) {
    leaves_.emplaceBack(value_count_);
    return ~static_cast<Child>(leaves_.size() - 1);
  }
  const Child child = free_leaves_.back();
  free_leaves_.pop_back();
  return child;
}

// A node split at `level`, with `child` on the side where `side_of` lies.
AtomTree::Child AtomTree::newInner(int level, const Eigen::Vector3f& side_of, Child child, Child other) {
  Inner node{{child, other},
             static_cast<float>(key(side_of).planeAt(level)) * cell_,
             static_cast<std::uint8_t>(level),
             static_cast<std::uint8_t>(CellKey::axisOf(level))};
  if (node.side(side_of) == 1) std::swap(node.children[0], node.children[1]);
  if (free_inners_.empty()) {
    inners_.emplaceBack(node);
    return static_cast<Child>(inners_.size() - 1);
  }
  const Child place = free_inners_.back();
  free_inners_.pop_back();
  inner(place) = node;
  return place;
}

void AtomTree::release(Child child) {
  if (isLeaf(child)) taken(child);
  (isLeaf(child) ? free_leaves_ : free_inners_).push_back(child);
}

// The leaf's atoms, which it holds no more.
AtomBlock AtomTree::taken(Child child) {
  block_bytes_ -= leaf(child).bytes();
  return std::exchange(leaf(child), AtomBlock(value_count_));
}

void AtomTree::clear() {
  *this = AtomTree(cell_, value_count_);
}

std::size_t AtomTree::bytes() const {
  return inners_.bytes() + leaves_.bytes() + (free_inners_.capacity() + free_leaves_.capacity()) * sizeof(Child) +
         block_bytes_;
}

// An insertion takes a lane in a block at most, or it splits a leaf, which adds a node of each kind.
std::size_t AtomTree::bytesAfterInsert() const {
  const std::size_t nodes =
      (free_inners_.empty() ? inners_.growth() : 0) + (free_leaves_.empty() ? leaves_.growth() : 0);
  const std::size_t split = 2 * kLane * (3U + static_cast<unsigned>(value_count_)) * sizeof(float) + 16;
  return bytes() + split + nodes;
}

std::size_t AtomTree::depth() const {
  return size_ == 0 ? 0 : depthBelow(root_);
}

std::size_t AtomTree::depthBelow(Child child) const {
  if (isLeaf(child)) return 0;
  return 1 + std::max(depthBelow(inner(child).children[0]), depthBelow(inner(child).children[1]));
}

}  // namespace atom_map
