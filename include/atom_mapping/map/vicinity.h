#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "atom_mapping/base/four_boxes.h"
#include "atom_mapping/base/lanes.h"
#include "atom_mapping/map/atom_tree.h"

namespace atom_map {

// Searches of one radius that come close after one another, as a scan's candidates do: the leaves around a block of space
// are looked up once and serve all searches in it. A search in a large tree takes most of its time on its way to the leaves.
class Vicinity {
 public:
  // `radius` of every search and `block`, the side of the blocks that space is cut into, in metres. The tree must outlive this.
  Vicinity(AtomTree& tree, float radius, float block) : tree_(tree), radius_(radius), side_(block) {}

  // Calls visit(AtomRef, squared distance) for each atom whose centre lies nearer to p than the radius.
  template <class Visit>
  void forEachWithin(const Eigen::Vector3f& p, Visit&& visit);

  void insert(const Eigen::Vector3f& center, const float* values) {
    if (tree_.insert(center, values)) forget();
  }

  // To be called when anyone else may have changed the tree.
  void forget() { leaves_.clear(); }

 private:
  // Some atoms of a leaf, from `first` on: as many as nearMask compares at once, which are all but of the fullest.
  struct Atoms {
    AtomBlock* block;
    std::uint32_t first;

    std::uint64_t nearMask(const Eigen::Vector3f& p, float squared_radius) const {
      return block->nearMask(p, squared_radius, first);
    }
  };

  void lookUp(const Eigen::Vector3f& p);
  void add(const Atoms& atoms, const Floats& min, const Floats& max);

  AtomTree& tree_;
  float radius_;
  float side_;
  Eigen::AlignedBox3f block_;     // whose searches the leaves serve
  std::vector<Atoms> leaves_;     // and some that hold nothing, up to whole lanes
  std::vector<FourBoxes> boxes_;  // of each four leaves
  std::vector<Atoms> near_;       // of the search at hand
  LeafSearch search_;
  AtomBlock empty_{1};
};

template <class Visit>
void Vicinity::forEachWithin(const Eigen::Vector3f& p, Visit&& visit) {
  if (leaves_.empty() || !block_.contains(p)) lookUp(p);
  // Without branches: which leaves a search meets is hard to foretell.
  Atoms* end = near_.data();
  for (std::size_t four = 0; four < boxes_.size(); ++four) {
    const Bits meet = boxes_[four].meet(p, radius_);
    for (std::uint32_t lane = 0; lane < kLane; ++lane) {
      *end = leaves_[four * kLane + lane];
      end -= meet[lane];  // -1 where it does
    }
  }
  *end = {&empty_, 0};
  // Two leaves at once, since it is hard to foretell too how many atoms of one are near.
  const float squared_radius = radius_ * radius_;
  for (const Atoms* two = near_.data(); two < end; two += 2) {
    std::uint64_t mask = two[0].nearMask(p, squared_radius) | two[1].nearMask(p, squared_radius)
                                                                  << AtomBlock::kMaskSize;
    for (; mask != 0; mask &= mask - 1) {
      const auto bit = static_cast<std::uint32_t>(__builtin_ctzll(mask));
      const Atoms& atoms = two[bit / AtomBlock::kMaskSize];
      const std::uint32_t index = atoms.first + bit % AtomBlock::kMaskSize;
      visit(AtomRef{atoms.block, index}, atoms.block->squaredDistance(index, p));
    }
  }
}

}  // namespace atom_map
