#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "atom_mapping/base/cell_table.h"
#include "atom_mapping/base/cells.h"

namespace atom_map {

// A set of cubic cells, for one pass over a scan: a bit a cell, in blocks of 4 x 4 x 4 in a hash table. Points that follow one
// another along a ray meet the same few blocks again and again, which stay in the processor's cache.
class CellSet {
  static constexpr int kShift = 2;

 public:
  static constexpr int kBlock = 1 << kShift;  // cells on the side of a block, of which a word holds a bit each

  // Quickest where points fall into about as many blocks as expected.
  CellSet(float cell_size, std::size_t expected_blocks)
      : cells_per_metre_(1.0F / cell_size), table_(static_cast<float>(kBlock) * cell_size, expected_blocks) {}

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
  struct Block {
    std::uint64_t cells = 0;  // a bit each
    std::uint32_t number = 0;
  };

  // The block's number; nothing if the cell was in the set already.
  std::optional<std::uint32_t> insert(const Cell& at) {
    Block& block = table_.at(Cell{at.x >> kShift, at.y >> kShift, at.z >> kShift});
    constexpr int kWithin = kBlock - 1;
    const std::uint64_t cell = std::uint64_t{1}
                               << ((at.x & kWithin) | (at.y & kWithin) << kShift | (at.z & kWithin) << 2 * kShift);
    if ((block.cells & cell) != 0) return std::nullopt;
    if (block.cells == 0) block.number = blocks_++;
    block.cells |= cell;
    return block.number;
  }

  float cells_per_metre_;
  CellTable<Block> table_;
  std::uint32_t blocks_ = 0;
};

}  // namespace atom_map
