#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "atom_mapping/map/atom_tree.h"

namespace atom_map {

// Searches of one radius that come close after one another, as a scan's candidates do: the leaves around a block of space
// are looked up once and serve all searches in it. A search in a large tree takes most of its time on its way to the leaves.
class Vicinity {
 public:
  // `radius` of every search and `block`, the side of the blocks that space is cut into, in metres. The tree must outlive this.
  Vicinity(AtomTree& atoms, float radius, float block) : atoms_(atoms), radius_(radius), side_(block) {}

  // Calls visit(AtomRef, squared distance) for each atom whose centre lies nearer to p than the radius.
  template <class Visit>
  void forEachWithin(const Eigen::Vector3f& p, Visit&& visit);

  void insert(const Eigen::Vector3f& center, const float* values) {
    if (atoms_.insert(center, values)) forget();
  }

  // To be called when anyone else may have changed the tree.
  void forget() { leaves_.clear(); }

 private:
  struct Leaf {
    AtomBlock* block;
    Eigen::AlignedBox3f box;  // that holds its atoms
  };

  void lookUp(const Eigen::Vector3f& p);

  AtomTree& atoms_;
  float radius_;
  float side_;
  Eigen::AlignedBox3f block_;  // whose searches the leaves serve
  std::vector<Leaf> leaves_;
  std::vector<AtomBlock*> near_;
};

template <class Visit>
void Vicinity::forEachWithin(const Eigen::Vector3f& p, Visit&& visit) {
  if (leaves_.empty() || !block_.contains(p)) lookUp(p);
  // Without branches: which leaves a search meets is hard to foretell.
  near_.resize(leaves_.size());
  std::size_t count = 0;
  for (const Leaf& leaf : leaves_) {
    near_[count] = leaf.block;
    const auto meets = [&](int axis) {
      return std::size_t{leaf.box.min()[axis] - p[axis] < radius_} &
             std::size_t{p[axis] - leaf.box.max()[axis] < radius_};
    };
    count += meets(0) & meets(1) & meets(2);
  }
  for (std::size_t i = 0; i < count; ++i) {
    AtomBlock& block = *near_[i];
    AtomTree::forEachNear(block, p, radius_ * radius_, [&](std::uint32_t atom, float squared_distance) {
      visit(AtomRef{&block, atom}, squared_distance);
    });
  }
}

}  // namespace atom_map
