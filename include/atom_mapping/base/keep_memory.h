#pragma once

#include <malloc.h>

#include <algorithm>
#include <cstddef>

namespace atom_map {

// For programs that map scans. By itself glibc gives the megabytes that a scan's stages have freed back to the kernel and gets
// them anew, page by page and zeroed, at the next scan: a third of the time of a scan at small radii. From now on it keeps up
// to 64 MB that are free.
inline void keepFreedMemory() {
  constexpr int kMegabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte);  // the most that glibc takes
  mallopt(M_TRIM_THRESHOLD, 64 * kMegabyte);
}

// Gives all that is free back to the kernel, wherever it lies in the heap. Takes milliseconds for each 100 MB.
inline void returnFreedMemory() {
  malloc_trim(0);
}

// Tells when to return freed memory: once what is in use has fallen by so much that it will not be used again soon.
class FallWatch {
 public:
  // Whether `bytes`, those in use now, are that much less than they were. Then counts from there.
  bool hasFallenTo(std::size_t bytes) {
    constexpr std::size_t kLeast = 16U << 20U;  // bytes
    most_ = std::max(most_, bytes);
    const std::size_t fall = most_ - bytes;
    if (fall < kLeast || fall < most_ / 4) return false;
    most_ = bytes;
    return true;
  }

 private:
  std::size_t most_ = 0;  // bytes, since the last fall
};

}  // namespace atom_map
