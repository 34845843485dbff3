#include "atom_mapping/ros/scan_counts.h"

#include <numeric>

namespace atom_mapping {

const char* toString(Drop cause) {
  static constexpr std::array<const char*, kDropCauses> kNames{"malformed",    "no transform", "bad transform",
                                                               "out of order", "time jump",    "overload"};
  return kNames[static_cast<std::size_t>(cause)];
}

std::uint64_t ScanCounts::droppedInAll() const {
  return std::accumulate(dropped.begin(), dropped.end(), std::uint64_t{0});
}

}  // namespace atom_mapping
