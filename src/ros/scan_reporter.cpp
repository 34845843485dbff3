#include "atom_mapping/ros/scan_reporter.h"

namespace atom_mapping {
namespace {

constexpr std::uint32_t kReportQueue = 100;  // messages

}  // namespace

ScanReporter::ScanReporter(const ros::NodeHandle& node, ros::NodeHandle private_node, const CloudServer& server,
                           const NodeDiagnostics::DescribeMap& describe_map)
    : diagnostics_(node, server, describe_map),
      reports_(private_node.advertise<ScanReport>("scan_report", kReportQueue, true)) {}

void ScanReporter::report(const sensor_msgs::PointCloud2& cloud, const ScanOutcome& outcome) {
  if (outcome.drop) {
    log_.warn(toString(*outcome.drop), "Dropped a cloud, " + outcome.message);
    return;
  }
  diagnostics_.noteScan(outcome.report, ros::Time::now().toSec() - cloud.header.stamp.toSec());
  reports_.publish(outcome.report);
}

}  // namespace atom_mapping
