// The index of the map: an incremental k-d tree whose leaves are buckets of atoms (paper III-B).
//
// Choice: nodes split at dyadic planes (multiples of cell * 2^n), the coarsest that separates what lies beneath, and
// chains of nodes with one child are never stored. So the tree's shape follows from where atoms lie and not from the
// order in which they came: a straight drive, sorted input or a plane cannot degenerate it, and it is never rebuilt.
//
// Complexity: the depth is at most 3 (ceil(log2(n)) + 1), n the cells on the longest axis of what the tree holds. For
// atoms no nearer to one another than a cell, insertion and removal cost O(depth), a search O(depth + atoms in the
// leaves that it touches). Atoms within the same cell cannot be separated: a leaf holds them all, however many.
//
// Thread safety: const members may run side by side; any other member needs the tree alone.
//
// Memory: each removal gives the atoms' own blocks back. The arrays of nodes give theirs back when less than half of them
// is used: the nodes then move to new arrays, in the tree's order, at a cost of O(nodes): 2 ms for a
// million atoms.
//
// Lifetime: an AtomRef is valid until the next insertion or removal; a Neighbor is a copy.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "atom_mapping/map/atom_block.h"
#include "atom_mapping/map/atom_ref.h"
#include "atom_mapping/map/cell_key.h"
#include "atom_mapping/map/chunked_array.h"
#include "atom_mapping/map/leaf_search.h"
#include "atom_mapping/map/tree_geometry.h"

namespace atom_map {

class AtomTree {
 public:
  static constexpr std::uint32_t kLeafCapacity = 32;  // atoms
  static constexpr std::size_t kEvery = std::numeric_limits<std::size_t>::max();

  // `cell`: side of the smallest cell that a split may make, in metres; rounded down to a power of two, so that floats
  // hold every plane exactly. `value_count`: floats that an atom stores, 1 or 2.
  AtomTree(float cell, int value_count);

  // Coordinates must be finite. `values` points to value_count floats. Returns whether leaves were added or moved, or
  // one holds more than kLeafCapacity.
  bool insert(const Eigen::Vector3f& center, const float* values);

  // Calls visit(ConstAtomRef, squared distance) for each atom whose centre lies nearer to p than `radius`. Who writes: see
  // Vicinity. With `signs`, atoms whose first value has none of them may be left out.
  template <class Visit>
  void forEachWithin(const Eigen::Vector3f& p, float radius, Visit&& visit,
                     AtomBlock::Signs signs = AtomBlock::kEverySign) const;

  // Calls visit(ConstAtomRef) for each atom whose centre lies nearer than `radius` to the straight way between two points,
  // in no particular order.
  template <class Visit>
  void forEachAlong(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius, Visit&& visit) const;

  // Calls visit(ConstAtomRef) for each atom whose centre lies in the closed box, or in the tree, in the tree's order.
  template <class Visit>
  void forEachInBox(const Eigen::AlignedBox3f& box, Visit&& visit) const;
  template <class Visit>
  void forEach(Visit&& visit) const;

  // Calls visit(const AtomBlock&) for the atoms of each leaf, in the tree's order: the quickest way to copy them all.
  template <class Visit>
  void forEachBlock(Visit&& visit) const;

  // Calls visit(AtomBlock&, min, max) for each leaf that meets the closed box, with the corners (x, y, z and a fourth that
  // means nothing) of the box that holds its atoms; sides that no plane bounds are infinite. The leaves stay where they are
  // until a removal or until insert() returns true.
  // `search`: the same for one search after another, which spares them its memory.
  template <class Visit>
  void forEachLeaf(const Eigen::AlignedBox3f& box, LeafSearch& search, Visit&& visit);

  // The centre of some atom nearer to p than `radius`, the first that is found.
  std::optional<Eigen::Vector3f> anyWithin(const Eigen::Vector3f& p, float radius) const;

  // The nearest atom whose centre lies nearer to p than max_distance.
  std::optional<Neighbor> nearest(const Eigen::Vector3f& p, float max_distance) const;

  // The k nearest atoms nearer to p than max_distance, nearest first. `neighbors` is overwritten.
  void kNearest(const Eigen::Vector3f& p, std::size_t k, float max_distance, std::vector<Neighbor>& neighbors) const;

  // Removes the atoms whose centres lie in the closed box; returns how many.
  std::size_t removeInBox(const Eigen::AlignedBox3f& box);

  // Removes the atoms that forEachWithin(p, radius) does not visit; returns how many. Stops once it has removed `at_most` and
  // the rest of a leaf: the fewer, the shorter it takes. Subtrees whose boxes lie within the radius cost nothing.
  std::size_t removeBeyond(const Eigen::Vector3f& p, float radius, std::size_t at_most = kEvery);

  void clear();

  // Gives back what the arrays of nodes hold beside the nodes, which removals do for most of it.
  void shrink() { compact(); }

  std::size_t size() const { return size_; }
  std::size_t depth() const;             // inner nodes on the longest way to a leaf
  std::size_t bytes() const;             // heap bytes held, of atoms and index; costs O(1)
  std::size_t bytesAfterInsert() const;  // at most

 private:
  static constexpr std::size_t kMaxDepth = 96;  // levels of CellKey

  // A child is an inner node's index, or the complement of a leaf's.
  using Child = std::int32_t;
  struct Inner {
    std::array<Child, 2> children;  // below the plane; on and above it
    float plane;                    // m, exact: a multiple of the cell
    std::uint8_t level;             // of the plane, as CellKey::firstDifference; falls on every way to a leaf
    std::uint8_t axis;

    std::size_t side(const Eigen::Vector3f& p) const { return p[axis] >= plane ? 1 : 0; }
  };
  // A node's children, seen from a point.
  struct Split {
    Child near;
    Child far;
    float distance;  // m, to the plane between them
  };
  // Where a child hangs: survives the growth of the node arrays, which a pointer does not.
  struct Place {
    Child parent;  // kRoot for the root
    std::size_t side;
  };
  static constexpr Child kRoot = -1;

  static bool isLeaf(Child c) { return c < 0; }
  AtomBlock& leaf(Child c) { return leaves_[static_cast<std::size_t>(~c)]; }
  const AtomBlock& leaf(Child c) const { return leaves_[static_cast<std::size_t>(~c)]; }
  Inner& inner(Child c) { return inners_[static_cast<std::size_t>(c)]; }
  const Inner& inner(Child c) const { return inners_[static_cast<std::size_t>(c)]; }
  Child& at(Place p) { return p.parent == kRoot ? root_ : inner(p.parent).children[p.side]; }

  CellKey key(const Eigen::Vector3f& p) const { return {p, cells_per_metre_}; }

  Child newLeaf();
  Child newInner(int level, const Eigen::Vector3f& side_of, Child child, Child other);
  void release(Child child);
  AtomBlock taken(Child child);
  bool splitIfOverfull(Place place);
  std::size_t depthBelow(Child child) const;

  // Calls change(AtomBlock&), which may change how many atoms the leaf holds.
  template <class Change>
  void changeLeaf(Child child, Change&& change) {
    block_bytes_ -= leaf(child).bytes();
    change(leaf(child));
    block_bytes_ += leaf(child).bytes();
  }
  template <class Region>
  std::size_t remove(const Region& region, std::size_t at_most);
  template <class Region>
  Child removeBelow(Child child, const Eigen::AlignedBox3f& bounds, const Region& region, std::size_t least_size);
  template <class Region>
  void removeInLeaf(Child child, const Region& region);
  Child joined(Child child, const std::array<Child, 2>& children);
  void compactIfMostlyEmpty();
  void compact();
  Child moveBelow(Child child, ChunkedArray<Inner>& inners, ChunkedArray<AtomBlock>& leaves);

  // Calls visit(index, squared distance) for each atom of a leaf nearer to p than the radius.
  template <class Visit>
  static void forEachNear(const AtomBlock& block, const Eigen::Vector3f& p, float squared_radius, Visit&& visit);
  template <class Visit>
  void visitLeaves(const Eigen::AlignedBox3f& box, Visit&& visit) const;
  void findLeaves(const Eigen::AlignedBox3f& box, LeafSearch& search);
  template <class FindLeaves, class Visit>
  void visitPrefetched(const FindLeaves& find_leaves, const Visit& visit) const;
  template <class Visit>
  void visitLeavesWithin(Child child, const Eigen::Vector3f& p, float squared_radius, const GapToBox& gap,
                         Visit&& visit) const;
  template <class Visit>
  void visitLeavesAlong(Child child, const CutWay& way, float begin, float end, Visit&& visit) const;
  static float widenedAt(const Eigen::Vector3f& p, float radius);
  Split splitAt(const Inner& node, const Eigen::Vector3f& p) const;
  std::optional<Eigen::Vector3f> anyBelow(Child child, const Eigen::Vector3f& p, float squared_radius,
                                          const GapToBox& gap) const;
  void kNearestBelow(Child child, const Eigen::Vector3f& p, std::size_t k, float max_squared_distance,
                     const GapToBox& gap, std::vector<Neighbor>& best) const;

  float cell_;  // m
  float cells_per_metre_;
  int value_count_;
  std::size_t size_ = 0;
  std::size_t block_bytes_ = 0;  // of all leaves' blocks
  Eigen::AlignedBox3f extent_;   // holds all centres; may be wider than they need
  Child root_ = 0;               // meaningful while size_ > 0
  ChunkedArray<Inner> inners_;
  ChunkedArray<AtomBlock> leaves_;
  std::vector<Child> free_inners_;
  std::vector<Child> free_leaves_;
};

}  // namespace atom_map

#include "atom_mapping/map/atom_tree_search.h"
