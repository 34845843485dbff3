#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "atom_mapping/map/hash_center.h"

namespace atom_map {

// A set of atoms, known by their centres.
class CenterSet {
 public:
  void insert(const Eigen::Vector3f& center) {
    std::uint64_t& slot = slotOf(hash(center));
    if (slot != kEmpty) return;
    slot = hash(center);
    if (2 * ++size_ > slots_.size()) grow();
  }

  bool contains(const Eigen::Vector3f& center) const {
    return const_cast<CenterSet*>(this)->slotOf(hash(center)) != kEmpty;
  }

 private:
  static constexpr std::uint64_t kEmpty = 0;

  // 64 bits: two of a scan's thousands of centres share them with a probability below 1e-11.
  static std::uint64_t hash(const Eigen::Vector3f& center) { return HashCenter()(center) | 1; }

  // The one that holds the hash, or the empty one where it belongs.
  std::uint64_t& slotOf(std::uint64_t hash) {
    std::size_t i = (hash >> 1) & (slots_.size() - 1);
    while (slots_[i] != kEmpty && slots_[i] != hash) i = (i + 1) & (slots_.size() - 1);
    return slots_[i];
  }

  void grow() {
    std::vector<std::uint64_t> old(2 * slots_.size(), kEmpty);
    old.swap(slots_);
    for (const std::uint64_t hash : old) {
      if (hash != kEmpty) slotOf(hash) = hash;
    }
  }

  std::size_t size_ = 0;
  std::vector<std::uint64_t> slots_ = std::vector<std::uint64_t>(1024, kEmpty);
};

}  // namespace atom_map
