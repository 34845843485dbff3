#pragma once

#include <malloc.h>

namespace atom_map {

// For programs that map scans. By itself glibc gives the megabytes that a scan's stages have freed back to the kernel and gets
// them anew, page by page and zeroed, at the next scan: a third of the time of a scan at small radii. From now on it keeps up
// to 64 MB that are free.
inline void keepFreedMemory() {
  constexpr int kMegabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte);  // the most that glibc takes
  mallopt(M_TRIM_THRESHOLD, 64 * kMegabyte);
}

}  // namespace atom_map
