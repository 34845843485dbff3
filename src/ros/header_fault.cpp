#include "atom_mapping/ros/header_fault.h"

#include <sstream>

#include "atom_mapping/ros/frame_name.h"

namespace atom_mapping {
namespace {

// tf2 adds the length of its memory to stamps, and throws in a thread of its own when the sum does not fit in 32 bits.
constexpr std::uint32_t kLastSecond = 0xFFFFFFFFU - 1000000U;
constexpr std::uint32_t kNanoseconds = 1000000000U;  // a second

}  // namespace

std::optional<std::string> headerFault(const std_msgs::Header& header) {
  const ros::Time& stamp = header.stamp;
  const std::string frame = withoutSlash(header.frame_id);
  if (frame.empty()) return "its frame_id is empty; it must name the sensor's frame";
  if (frame.front() == '/') return "its frame_id begins with slashes; it must name the sensor's frame";
  if (stamp.isZero()) return "its stamp is zero; it must be the time of the scan";
  if (stamp.sec <= kLastSecond && stamp.nsec < kNanoseconds) return std::nullopt;
  std::ostringstream fault;
  fault << "its stamp is " << stamp.sec << " s and " << stamp.nsec << " ns; it must be the time of the scan";
  return fault.str();
}

}  // namespace atom_mapping
