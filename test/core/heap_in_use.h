#pragma once

#include <malloc.h>

#include <cstddef>

#if defined(__SANITIZE_ADDRESS__)
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();
#endif

namespace atom_map {

// Bytes that the program holds on the heap, by the allocator's own count. Some 100 kB of freed blocks may be among
// them.
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

}  // namespace atom_map
