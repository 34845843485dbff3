#include <algorithm>
#include <cassert>
#include <utility>

#include "atom_mapping/map/atom_tree.h"

namespace atom_map {
namespace {

// Nodes that are there beside those in use before the tree moves to smaller arrays.
constexpr std::size_t kSpareNodes = 64;

// What a removal takes: each region tells whether a point lies in it, and whether a box may meet it.
struct InBox {
  const Eigen::AlignedBox3f& box;

  bool contains(const AtomBlock& block, std::uint32_t i) const { return box.contains(block.center(i)); }
  bool meets(const Eigen::AlignedBox3f& bounds) const { return box.intersects(bounds); }
};

struct Beyond {
  const Eigen::Vector3f& p;
  float squared_radius;

  bool contains(const AtomBlock& block, std::uint32_t i) const {
    return !(block.squaredDistance(i, p) < squared_radius);
  }
  bool meets(const Eigen::AlignedBox3f& bounds) const {
    constexpr float kRounding = 1e-6F;
    const Eigen::Vector3f farthest = (bounds.min() - p).cwiseAbs().cwiseMax((bounds.max() - p).cwiseAbs());
    return !(farthest.squaredNorm() * (1.0F + kRounding) < squared_radius);
  }
};

}  // namespace

std::size_t AtomTree::removeInBox(const Eigen::AlignedBox3f& box) {
  return box.isEmpty() ? 0 : remove(InBox{box}, kEvery);
}

std::size_t AtomTree::removeBeyond(const Eigen::Vector3f& p, float radius, std::size_t at_most) {
  assert(radius >= 0.0F && at_most > 0);
  const std::size_t removed = remove(Beyond{p, radius * radius}, at_most);
  if (size_ > 0 && removed < at_most) {  // all is within: the box of a long drive shrinks to what is left of it
    const float rounding = kTreeRounding * (radius + p.cwiseAbs().maxCoeff());
    const Eigen::Vector3f reach = Eigen::Vector3f::Constant(radius + 2.0F * rounding);
    extent_ = extent_.intersection(Eigen::AlignedBox3f(p - reach, p + reach));
  }
  return removed;
}

template <class Region>
std::size_t AtomTree::remove(const Region& region, std::size_t at_most) {
  if (size_ == 0) return 0;
  const std::size_t before = size_;
  root_ = removeBelow(root_, extent_, region, before - std::min(before, at_most));
  if (size_ == 0) clear();
  compactIfMostlyEmpty();
  return before - size_;
}

// Returns what takes the child's place: itself, its only child that is left, or two leaves joined. A leaf that comes back
// empty is the caller's to release. Nothing more is removed once the tree has the least size.
template <class Region>
AtomTree::Child AtomTree::removeBelow(Child child, const Eigen::AlignedBox3f& bounds, const Region& region,
                                      std::size_t least_size) {
  if (size_ <= least_size || !region.meets(bounds)) return child;
  if (isLeaf(child)) {
    removeInLeaf(child, region);
    return child;
  }
  const Inner node = inner(child);
  std::array<Eigen::AlignedBox3f, 2> halves{bounds, bounds};
  halves[0].max()[node.axis] = node.plane;
  halves[1].min()[node.axis] = node.plane;
  std::array<Child, 2> left{};
  for (std::size_t side = 0; side < 2; ++side) {
    left[side] = removeBelow(node.children[side], halves[side], region, least_size);
  }
  inner(child).children = left;
  return joined(child, left);
}

template <class Region>
void AtomTree::removeInLeaf(Child child, const Region& region) {
  const std::uint32_t before = leaf(child).size();
  std::uint32_t removed = 0;
  for (std::uint32_t i = 0; i < before; ++i) removed += region.contains(leaf(child), i) ? 1 : 0;
  if (removed == before) taken(child);
  if (removed > 0 && removed < before) {
    changeLeaf(child, [&](AtomBlock& block) {
      for (std::uint32_t i = before; i-- > 0;) {
        if (region.contains(block, i)) block.remove(i);
      }
    });
  }
  size_ -= removed;
}

// Two leaves become one as soon as one has room for both. So the tree is at any time the one that its atoms would make if they
// were inserted in its order: a map that was saved and loaded goes on as the one that was not.
AtomTree::Child AtomTree::joined(Child child, const std::array<Child, 2>& children) {
  const auto [first, second] = children;
  if (isLeaf(first) && isLeaf(second) && leaf(first).size() + leaf(second).size() <= kLeafCapacity) {
    const AtomBlock atoms = taken(second);
    changeLeaf(first, [&](AtomBlock& block) {
      for (std::uint32_t i = 0; i < atoms.size(); ++i) block.push(atoms, i);
    });
  }
  for (std::size_t side = 0; side < 2; ++side) {
    if (!isLeaf(children[side]) || leaf(children[side]).size() > 0) continue;
    release(children[side]);
    release(child);
    return children[1 - side];
  }
  return child;
}

void AtomTree::compactIfMostlyEmpty() {
  const std::size_t used = leaves_.size() - free_leaves_.size();
  if (leaves_.size() > 2 * used + kSpareNodes) compact();
}

// Moves the nodes to arrays that hold no others.
void AtomTree::compact() {
  if (size_ == 0) return;
  ChunkedArray<Inner> inners;
  ChunkedArray<AtomBlock> leaves;
  root_ = moveBelow(root_, inners, leaves);
  inners.shrink();
  leaves.shrink();
  inners_ = std::move(inners);
  leaves_ = std::move(leaves);
  free_inners_ = {};
  free_leaves_ = {};
}

// Returns where the child lies in the new arrays.
AtomTree::Child AtomTree::moveBelow(Child child, ChunkedArray<Inner>& inners, ChunkedArray<AtomBlock>& leaves) {
  if (isLeaf(child)) {
    leaves.emplaceBack(std::move(leaf(child)));
    return ~static_cast<Child>(leaves.size() - 1);
  }
  const std::size_t place = inners.size();
  inners.emplaceBack(inner(child));
  for (std::size_t side = 0; side < 2; ++side) {
    const Child moved = moveBelow(inner(child).children[side], inners, leaves);
    inners[place].children[side] = moved;
  }
  return static_cast<Child>(place);
}

}  // namespace atom_map
