#include "atom_mapping/ros/throttled_log.h"

#include <ros/console.h>

namespace atom_mapping {

void ThrottledLog::warn(const std::string& kind, const std::string& message) {
  const std::lock_guard lock(mutex_);
  Kind& state = kinds_[kind];
  const auto now = std::chrono::steady_clock::now();
  if (now < state.next) {
    ++state.left_out;
    return;
  }
  const std::string more = state.left_out > 0 ? " (and " + std::to_string(state.left_out) + " more since)" : "";
  ROS_WARN_STREAM(message << more);
  state = {now + kPeriod, 0};
}

}  // namespace atom_mapping
