#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "atom_mapping/base/cell_hash.h"
#include "atom_mapping/base/cells.h"

namespace atom_map {

// A hash table from cubic cells to a value each, for one pass over a scan.
template <class Value>
class CellTable {
 public:
  // Quickest where it is asked for about as many cells as expected.
  CellTable(float cell_size, std::size_t expected_cells)
      : cells_per_metre_(1.0F / cell_size), slots_(slotsFor(expected_cells)) {}

  // The value of the cell, or of the one that holds the point, made from Value() at the first call. Valid until the next call.
  Value& at(const Cell& cell) {
    const std::uint64_t key = cellKey(cell);
    Slot* slot = &slotOf(key);
    if (slot->key == key) return slot->value;
    if (2 * ++size_ > slots_.size()) {
      grow();
      slot = &slotOf(key);
    }
    slot->key = key;
    return slot->value;
  }
  Value& at(const Eigen::Vector3f& point) { return at(cellOf(point, cells_per_metre_)); }

  // Calls visit(i, value) for each i below `count`, with the value of the cell that holds point_of(i).
  template <class PointOf, class Visit>
  void atEach(std::size_t count, const PointOf& point_of, Visit&& visit) {
    forEachCell(count, cells_per_metre_, point_of, [&](std::size_t i, const Cell& cell) { visit(i, at(cell)); });
  }

  // Calls visit(value) for each cell that was asked for, in no particular order.
  template <class Visit>
  void forEach(Visit&& visit) const {
    for (const Slot& slot : slots_) {
      if (slot.key != kEmpty) visit(slot.value);
    }
  }

 private:
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};  // no cell's key
  struct Slot {
    std::uint64_t key = kEmpty;
    Value value{};
  };

  // The one that holds the key, or the empty one where it belongs.
  Slot& slotOf(std::uint64_t key) {
    std::size_t i = firstSlot(key, slots_.size());
    while (slots_[i].key != kEmpty && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
    return slots_[i];
  }

  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (Slot& slot : old) {
      if (slot.key != kEmpty) slotOf(slot.key) = std::move(slot);
    }
  }

  float cells_per_metre_;
  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

}  // namespace atom_map
