#pragma once

#include <malloc.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#if defined(__SANITIZE_ADDRESS__)
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();
#endif

namespace atom_map {

// Bytes that the program holds on the heap, of all threads, by the allocator's own count. Some 100 kB of freed blocks may
// be among them.
inline std::size_t heapInUse() {
#if defined(__SANITIZE_ADDRESS__)
  return __sanitizer_get_current_allocated_bytes();
#elif __GLIBC_PREREQ(2, 33)
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
#else
  const auto info = mallinfo();
  return static_cast<unsigned>(info.uordblks) + static_cast<unsigned>(info.hblkhd);
#endif
}

// glibc keeps up to seven freed blocks of each size below 1 kB at hand and counts them as in use. With these places
// taken, what is freed next is counted as free.
inline void fillThreadCache() {
  constexpr std::size_t kBlocks = 7;
  std::vector<std::unique_ptr<std::byte[]>> blocks;
  for (std::size_t size = 24; size <= 1032; size += 16) {
    for (std::size_t i = 0; i < kBlocks; ++i) blocks.push_back(std::make_unique<std::byte[]>(size));
  }
}

// Bytes of heap that release() gives back, by the allocator's own count: its headers and rounding are among them.
template <class Release>
std::size_t heapReleasedBy(Release&& release) {
  fillThreadCache();
  const std::size_t before = heapInUse();
  std::forward<Release>(release)();
  return before - heapInUse();
}

}  // namespace atom_map
