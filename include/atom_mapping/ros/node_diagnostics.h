#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>

#include <chrono>
#include <mutex>

#include "atom_mapping/ros/scan_server.h"

namespace atom_mapping {

// /diagnostics, once a second of wall time: scan rate, delay, drops by cause, map size.
// Thread safety: noteScan may be called from any thread.
class NodeDiagnostics {
 public:
  // Reports are sent from the node's callback queue.
  NodeDiagnostics(const ros::NodeHandle& node, const ScanServer& server);

  // Of each scan that was mapped. `delay`: s from its stamp to its being in the map.
  void noteScan(const ScanReport& report, double delay);

 private:
  using Clock = std::chrono::steady_clock;
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  void describeScans(Status& status);
  void describeMap(Status& status);

  // Since the last report.
  struct Interval {
    Clock::time_point start = Clock::now();
    int scans = 0;
    double longest_delay = 0.0;    // s
    double longest_mapping = 0.0;  // s
  };

  const ScanServer& server_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
  std::uint64_t dropped_before_ = 0;
  std::mutex mutex_;  // of what follows
  Interval interval_;
  ScanReport last_;
};

}  // namespace atom_mapping
