#pragma once

#include <chrono>

namespace atom_map {

// Calls stage() and adds the wall-clock time that it took. Returns what it returns.
template <class Stage>
auto timed(double& seconds, Stage&& stage) {
  const auto start = std::chrono::steady_clock::now();
  auto result = stage();
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace atom_map
