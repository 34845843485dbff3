#pragma once

#include <cstdint>

namespace atom_map {

// The greatest integer that is not above a number within the range of integers. Without SSE 4.1 std::floor is a call.
inline std::int32_t floorToInt(float number) {
  const auto towards_zero = static_cast<std::int32_t>(number);
  return towards_zero - (static_cast<float>(towards_zero) > number ? 1 : 0);
}

}  // namespace atom_map
