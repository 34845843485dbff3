#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>

#include <chrono>
#include <functional>
#include <mutex>

#include "atom_mapping/ros/baseline_server.h"
#include "atom_mapping/ros/scan_server.h"

namespace atom_mapping {

// What /diagnostics tells of a map: its size and kind.
void describeMap(const ScanServer& server, diagnostic_updater::DiagnosticStatusWrapper& status);
void describeMap(const BaselineServer& server, diagnostic_updater::DiagnosticStatusWrapper& status);

// /diagnostics, once a second of wall time: scan rate, delay, drops by cause, map size. While no cloud comes, the log too
// says what may be wrong.
// Thread safety: noteScan may be called from any thread.
class NodeDiagnostics {
 public:
  using DescribeMap = std::function<void(diagnostic_updater::DiagnosticStatusWrapper&)>;

  // Reports are sent from the node's callback queue; `node` subscribes to cloud_in.
  NodeDiagnostics(const ros::NodeHandle& node, const CloudServer& server, const DescribeMap& describe_map);

  // Of each scan that was mapped. `delay`: s from its stamp to its being in the map.
  void noteScan(const ScanReport& report, double delay);

 private:
  using Clock = std::chrono::steady_clock;
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  void describeScans(Status& status);
  void describeWaiting(Status& status);

  // Since the last report.
  struct Interval {
    Clock::time_point start = Clock::now();
    int scans = 0;
    double longest_delay = 0.0;    // s
    double longest_mapping = 0.0;  // s
  };

  const CloudServer& server_;
  std::string topic_;  // of the clouds
  Clock::time_point next_look_;
  std::string silence_;  // what is known of why no cloud comes; empty at first
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
  std::uint64_t dropped_before_ = 0;
  std::mutex mutex_;  // of what follows
  Interval interval_;
  ScanReport last_;
};

}  // namespace atom_mapping
