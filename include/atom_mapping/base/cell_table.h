#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

#include "atom_mapping/base/random.h"

namespace atom_map {

// A hash table from cubic cells to a value each, for one pass over a scan. Sized once: may take up to `expected` cells.
template <class Value>
class CellTable {
 public:
  CellTable(float cell_size, std::size_t expected) : cells_per_metre_(1.0F / cell_size) {
    std::size_t capacity = 16;
    while (capacity < 2 * expected) capacity *= 2;
    slots_.resize(capacity);
  }

  // The value of the cell that holds the point, made from Value() at the first call.
  Value& at(const Eigen::Vector3f& point) {
    const std::uint64_t key = keyOf(point);
    std::size_t i = mixBits(key) & (slots_.size() - 1);
    while (slots_[i].key != kEmpty && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
    slots_[i].key = key;
    return slots_[i].value;
  }

 private:
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};  // keyOf never gives it: it uses 63 bits
  struct Slot {
    std::uint64_t key = kEmpty;
    Value value{};
  };

  std::uint64_t keyOf(const Eigen::Vector3f& p) const {
    constexpr std::int64_t kMask = (1 << 21) - 1;
    const auto cell = [&](int axis) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(p[axis] * cells_per_metre_)) & kMask);
    };
    return cell(0) << 42 | cell(1) << 21 | cell(2);
  }

  float cells_per_metre_;
  std::vector<Slot> slots_;
};

}  // namespace atom_map
