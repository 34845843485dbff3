#pragma once

#include <cstdint>

namespace atom_map {

// Vectors of four floats and of the answers to comparisons of them (-1 for yes), which every processor of the last twenty years
// takes at once.
constexpr std::uint32_t kLane = 4;
using Floats = float __attribute__((vector_size(sizeof(float) * kLane)));
using Bits = std::int32_t __attribute__((vector_size(sizeof(float) * kLane)));

// The lane that holds the least number, the first of those that do.
inline std::uint32_t indexOfLeast(const Floats& numbers) {
  const std::uint32_t low = numbers[1] < numbers[0] ? 1 : 0;
  const std::uint32_t high = numbers[3] < numbers[2] ? 3 : 2;
  return numbers[high] < numbers[low] ? high : low;
}

// The bits that any lane has.
inline std::uint32_t unionOf(const Bits& bits) {
  return static_cast<std::uint32_t>(bits[0] | bits[1] | bits[2] | bits[3]);
}

}  // namespace atom_map
