#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "atom_mapping/base/cell_hash.h"
#include "atom_mapping/base/floor_to_int.h"

namespace atom_map {

// A set of cubic cells, for one pass over a scan: a bit a cell, in blocks of 4 x 4 x 4 in a hash table. Points that follow one
// another along a ray meet the same few blocks again and again, which stay in the processor's cache.
class CellSet {
 public:
  // Quickest where points fall into about as many blocks as expected.
  CellSet(float cell_size, std::size_t expected_blocks)
      : cells_per_metre_(1.0F / cell_size), slots_(slotsFor(expected_blocks)) {}

  // Adds the cell that holds the point. Returns the block's number, counted from 0 in the order of their first cells, or
  // nothing if the cell was in the set already.
  std::optional<std::uint32_t> insert(const Eigen::Vector3f& point) {
    const std::int32_t x = cellOf(point.x());
    const std::int32_t y = cellOf(point.y());
    const std::int32_t z = cellOf(point.z());
    Slot& slot = slotOf(cellKey(x >> 2, y >> 2, z >> 2));
    const std::uint64_t cell = std::uint64_t{1} << ((x & 3) | (y & 3) << 2 | (z & 3) << 4);
    if ((slot.cells & cell) != 0) return std::nullopt;
    if (slot.cells == 0) slot.number = blocks_++;
    slot.cells |= cell;
    const std::uint32_t number = slot.number;
    if (2 * blocks_ > slots_.size()) grow();
    return number;
  }

  std::uint32_t blocks() const { return blocks_; }

 private:
  struct Slot {
    std::uint64_t key;
    std::uint64_t cells = 0;  // 0: the slot is empty
    std::uint32_t number;
  };

  std::int32_t cellOf(float coordinate) const { return floorToInt(coordinate * cells_per_metre_); }

  Slot& slotOf(std::uint64_t key) {
    std::size_t i = firstSlot(key, slots_.size());
    while (slots_[i].cells != 0 && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
    slots_[i].key = key;
    return slots_[i];
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.cells != 0) slotOf(slot.key) = slot;
    }
  }

  float cells_per_metre_;
  std::vector<Slot> slots_;
  std::uint32_t blocks_ = 0;
};

}  // namespace atom_map
