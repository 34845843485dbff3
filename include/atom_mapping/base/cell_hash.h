#pragma once

#include <cstddef>
#include <cstdint>

#include "atom_mapping/base/cells.h"

namespace atom_map {

// What hash tables of cubic cells share: how a cell becomes a key, and a key a place in a table of 2^n slots.

// Of coordinates in cells, of which the lowest 21 bits count. Uses 63 bits.
inline std::uint64_t cellKey(const Cell& cell) {
  constexpr std::uint64_t kMask = (1U << 21U) - 1U;
  return (static_cast<std::uint64_t>(cell.x) & kMask) << 42U | (static_cast<std::uint64_t>(cell.y) & kMask) << 21U |
         (static_cast<std::uint64_t>(cell.z) & kMask);
}

// Where the search for a key begins in a table of so many slots, a power of two and at least 2. Fibonacci hashing: a
// multiplication, whose upper bits are well mixed.
inline std::size_t firstSlot(std::uint64_t key, std::size_t slots) {
  const int bits = __builtin_ctzll(slots);
  return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ULL) >> (64 - bits));
}

// Slots of a table that so many cells fill to a half at most.
inline std::size_t slotsFor(std::size_t cells) {
  std::size_t slots = 16;
  while (slots < 2 * cells) slots *= 2;
  return slots;
}

}  // namespace atom_map
