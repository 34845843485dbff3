#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace atom_mapping {

// Why a cloud was not mapped.
enum class Drop {
  kMalformed,     // its header, fields, sizes and data contradict one another
  kNoTransform,   // tf could not bring its frame to the map frame at its stamp
  kBadTransform,  // tf's answer is no rigid motion
  kOutOfOrder,    // its stamp lies before that of a cloud that is in the map
  kTimeJump,      // time jumped back while it waited
  kOverload,      // clouds came faster than they could be mapped
};
constexpr std::size_t kDropCauses = 6;

// As diagnostics and summaries name it, such as "no transform".
const char* toString(Drop cause);

// What became of the clouds so far.
struct ScanCounts {
  std::uint64_t mapped = 0;
  std::uint64_t empty = 0;  // of these: without any point
  std::array<std::uint64_t, kDropCauses> dropped{};
  std::string last_drop;  // why, in words; empty if none was dropped

  std::uint64_t droppedFor(Drop cause) const { return dropped[static_cast<std::size_t>(cause)]; }
  std::uint64_t droppedInAll() const;
};

}  // namespace atom_mapping
