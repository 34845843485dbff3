#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "atom_mapping/map/atom_block.h"

namespace atom_map {

// An atom where it lies in the tree.
template <class Block>
struct BasicAtomRef {
  Block* block;
  std::uint32_t index;

  Eigen::Vector3f center() const { return block->center(index); }
  float value(int v = 0) const { return block->channel(3 + v)[index]; }
  void setValue(int v, float value) const { block->setValue(index, v, value); }
};
using AtomRef = BasicAtomRef<AtomBlock>;
using ConstAtomRef = BasicAtomRef<const AtomBlock>;

struct Neighbor {
  Eigen::Vector3f center;
  float squared_distance;
  std::array<float, 2> values;  // as many as the tree has, then 0
};

}  // namespace atom_map
