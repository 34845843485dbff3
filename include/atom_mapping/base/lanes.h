#pragma once

#include <cstdint>

namespace atom_map {

// Vectors of four floats and of the answers to comparisons of them (-1 for yes), which every processor of the last twenty years
// takes at once.
constexpr std::uint32_t kLane = 4;
using Floats = float __attribute__((vector_size(sizeof(float) * kLane)));
using Bits = std::int32_t __attribute__((vector_size(sizeof(float) * kLane)));

}  // namespace atom_map
