#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "atom_mapping/base/cell_hash.h"
#include "atom_mapping/base/cells.h"

namespace atom_map {

// A set of cubic cells, for one pass over a scan: a bit a cell, in blocks of 4 x 4 x 4 in a hash table. Points that follow one
// another along a ray meet the same few blocks again and again, which stay in the processor's cache.
class CellSet {
 public:
  // Quickest where points fall into about as many blocks as expected.
  CellSet(float cell_size, std::size_t expected_blocks)
      : cells_per_metre_(1.0F / cell_size), slots_(slotsFor(expected_blocks)) {}

  // Adds the cells that hold the points. Calls visit(i, block) for each point i below `count` whose cell was not in the set yet,
  // with the number of its block, counted from 0 in the order of their first cells.
  template <class PointOf, class Visit>
  void insertEach(std::size_t count, const PointOf& point_of, Visit&& visit) {
    forEachCell(count, cells_per_metre_, point_of, [&](std::size_t i, const Cell& cell) {
      if (const auto block = insert(cell)) visit(i, *block);
    });
  }

  std::uint32_t blocks() const { return blocks_; }

 private:
  struct Slot {
    std::uint64_t key;
    std::uint64_t cells = 0;  // 0: the slot is empty
    std::uint32_t number;
  };

  // The block's number; nothing if the cell was in the set already.
  std::optional<std::uint32_t> insert(const Cell& at) {
    Slot& slot = slotOf(cellKey({at.x >> 2, at.y >> 2, at.z >> 2}));
    const std::uint64_t cell = std::uint64_t{1} << ((at.x & 3) | (at.y & 3) << 2 | (at.z & 3) << 4);
    if ((slot.cells & cell) != 0) return std::nullopt;
    if (slot.cells == 0) slot.number = blocks_++;
    slot.cells |= cell;
    const std::uint32_t number = slot.number;
    if (2 * blocks_ > slots_.size()) grow();
    return number;
  }

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
