// How large a map may grow.
#pragma once

#include <cstddef>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/map/atom_tree.h"

namespace atom_map {

struct MapLimit {
  std::size_t atoms = AtomTree::kEvery;
  std::size_t bytes = AtomTree::kEvery;  // of AtomTree::bytes()

  bool holds(const AtomTree& tree) const { return tree.size() <= atoms && tree.bytes() <= bytes; }
  // Whether it still holds after an insertion, whichever.
  // Choice: of bytes that is asked for the worst insertion, at which the arrays of nodes grow. So a map may be full some
  // kilobytes early, and its bytes never pass the limit.
  bool hasRoom(const AtomTree& tree) const { return tree.size() < atoms && tree.bytesAfterInsert() <= bytes; }
};

// Without regard to the policy.
inline MapLimit limitOf(const LimitParameters& parameters) {
  constexpr double kMegabyte = 1e6;
  MapLimit limit;
  if (parameters.max_atoms > 0) limit.atoms = parameters.max_atoms;
  if (parameters.max_megabytes > 0.0) limit.bytes = static_cast<std::size_t>(kMegabyte * parameters.max_megabytes);
  return limit;
}

}  // namespace atom_map
