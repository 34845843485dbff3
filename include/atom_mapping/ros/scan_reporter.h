#pragma once

#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include "atom_mapping/ros/node_diagnostics.h"
#include "atom_mapping/ros/throttled_log.h"

namespace atom_mapping {

// Tells what became of each cloud: ~scan_report and /diagnostics of those that were mapped, the log of the others
// and of those that found the map full.
// Thread safety: report may be called from any thread.
class ScanReporter {
 public:
  // `private_node`: of the node's `~`.
  ScanReporter(const ros::NodeHandle& node, ros::NodeHandle private_node, const CloudServer& server,
               const NodeDiagnostics::DescribeMap& describe_map);

  void report(const sensor_msgs::PointCloud2& cloud, const ScanOutcome& outcome);

 private:
  ThrottledLog log_;
  NodeDiagnostics diagnostics_;
  ros::Publisher reports_;
};

}  // namespace atom_mapping
