#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstring>
#include <unordered_set>

#include "atom_mapping/base/random.h"

namespace atom_map {

// A set of atoms, known by their centres: an atom's place in the tree changes, its centre never does.
class CenterSet {
 public:
  void insert(const Eigen::Vector3f& center) { hashes_.insert(hash(center)); }
  bool contains(const Eigen::Vector3f& center) const { return hashes_.count(hash(center)) > 0; }

 private:
  // 64 bits: two of a scan's thousands of centres share them with a probability below 1e-11.
  static std::uint64_t hash(const Eigen::Vector3f& center) {
    std::uint64_t xy = 0;
    std::uint32_t z = 0;
    std::memcpy(&xy, center.data(), sizeof xy);
    std::memcpy(&z, center.data() + 2, sizeof z);
    return mixBits(mixBits(xy) + z);
  }

  struct AlreadyMixed {
    std::size_t operator()(std::uint64_t h) const { return static_cast<std::size_t>(h); }
  };
  std::unordered_set<std::uint64_t, AlreadyMixed> hashes_;
};

}  // namespace atom_map
