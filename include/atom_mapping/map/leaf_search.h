#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "atom_mapping/base/lanes.h"

namespace atom_map {

// What AtomTree::forEachLeaf needs to work.
class LeafSearch {
 private:
  friend class AtomTree;
  struct Node {
    Floats min;  // m, of the box that the node's way through the planes leaves; the fourth means nothing
    Floats max;
    std::int32_t child;  // as AtomTree::Child
  };
  std::vector<Node> waiting_;  // inner nodes
  std::vector<Node> leaves_;
  std::size_t leaf_count_ = 0;
};

}  // namespace atom_map
