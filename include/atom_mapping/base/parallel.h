#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace atom_map {

// Cuts [0, count) into ranges and calls work(begin, end) for each once, from up to `threads` threads at a time, each of
// which calls make_worker() for a worker of its own; fewer where the system has no more. Returns when all is done. Workers must
// not throw.
template <class MakeWorker>
void parallelFor(std::size_t count, unsigned threads, const MakeWorker& make_worker) {
  constexpr std::size_t kRange = 256;  // some milliseconds of regression
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    auto work = make_worker();
    for (std::size_t begin = next.fetch_add(kRange); begin < count; begin = next.fetch_add(kRange)) {
      work(begin, std::min(begin + kRange, count));
    }
  };
  const std::size_t useful = std::min<std::size_t>(threads, (count + kRange - 1) / kRange);
  std::vector<std::thread> others;
  try {
    for (std::size_t i = 1; i < useful; ++i) others.emplace_back(run);
  } catch (const std::system_error&) {  // those that there are do it all
  }
  run();
  for (std::thread& other : others) other.join();
}

}  // namespace atom_map
