// Names within a map file; for saveMap and loadMap, and whoever tests them.
#pragma once

#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "atom_mapping/base/parameters.h"

namespace atom_map::map_file {

constexpr std::uint32_t kFormatVersion = 1;
constexpr std::uint64_t kChunk = 1U << 16U;   // atoms, of which a chunk holds one coordinate or value
constexpr std::uint64_t kLongestText = 4096;  // bytes, of a parameter

constexpr const char* kFormatVersionName = "format_version";
constexpr const char* kScans = "scans";
constexpr const char* kAtoms = "atoms";
constexpr const char* kOrigin = "origin";
constexpr const char* kParameters = "parameters";
constexpr const char* kCenters = "centers";
constexpr const char* kKnownPlanes = "known_planes";
constexpr std::size_t kPlaneWidth = 8;  // floats of a known plane

// What all faults of a file are thrown by.
template <class... Parts>
[[noreturn]] void fail(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  throw std::runtime_error(text.str());
}

// The datasets of an atom's values, in their order.
inline std::vector<std::string> valueNames(Mode mode) {
  if (mode == Mode::kOccupancy) return {"log_odds"};
  return {"signed_distance", "variance"};
}

inline const char* nameOf(Mode mode) {
  return mode == Mode::kOccupancy ? "occupancy" : "signed_distance";
}

inline const char* nameOf(LimitPolicy policy) {
  return policy == LimitPolicy::kRefuse ? "refuse" : "forget_farthest";
}

}  // namespace atom_map::map_file
