#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

namespace atom_mapping {

// Warnings to the ROS log, at most one of a kind every kPeriod; the next one says how many were left out.
// Thread safety: may be called from any thread.
class ThrottledLog {
 public:
  static constexpr std::chrono::seconds kPeriod{5};  // of wall time

  void warn(const std::string& kind, const std::string& message);

 private:
  struct Kind {
    std::chrono::steady_clock::time_point next{};
    int left_out = 0;
  };

  std::mutex mutex_;
  std::map<std::string, Kind> kinds_;
};

}  // namespace atom_mapping
