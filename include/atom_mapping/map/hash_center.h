#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstring>

#include "atom_mapping/base/random.h"

namespace atom_map {

// An atom's place in the tree changes, its centre never does: the bits of its coordinates, mixed.
struct HashCenter {
  std::uint64_t operator()(const Eigen::Vector3f& center) const {
    std::uint64_t xy = 0;
    std::uint32_t z = 0;
    std::memcpy(&xy, center.data(), sizeof xy);
    std::memcpy(&z, center.data() + 2, sizeof z);
    return mixBits(xy * 0x9e3779b97f4a7c15ULL + z);
  }
};

}  // namespace atom_map
