#include "atom_mapping/ros/scan_reporter.h"

#include <sstream>

namespace atom_mapping {
namespace {

constexpr std::uint32_t kReportQueue = 100;  // messages

std::string describeRefusal(const ScanReport& report) {
  std::ostringstream text;
  text << "The map is full: it refused " << report.atoms_refused << " new atoms and keeps its " << report.atoms << " ("
       << 1e-6 * static_cast<double>(report.map_bytes) << " MB). Raise limits/max_atoms or limits/max_megabytes, call "
       << "~clear_region, or set limits/policy to forget_farthest";
  return text.str();
}

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
  if (outcome.report.atoms_refused > 0) log_.warn("full", describeRefusal(outcome.report));
}

}  // namespace atom_mapping
