#include "atom_mapping/ros/node_diagnostics.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "atom_mapping/io/map_file_format.h"
#include "atom_mapping/ros/cloud_silence.h"

namespace atom_mapping {
namespace {

constexpr double kPeriod = 1.0;                  // s
constexpr std::chrono::seconds kLookPeriod{10};  // of wall time: how often it is asked why no cloud comes

}  // namespace

void describeMap(const ScanServer& server, diagnostic_updater::DiagnosticStatusWrapper& status) {
  const auto [atoms, bytes] =
      server.read([](const atom_map::AtomMap& map) { return std::make_pair(map.atoms().size(), map.atoms().bytes()); });
  const LimitCounts limits = server.limitCounts();
  if (limits.is_full) {
    status.summaryf(diagnostic_msgs::DiagnosticStatus::WARN,
                    "full at %zu atoms, new ones are refused; raise limits/max_atoms or limits/max_megabytes, or set "
                    "limits/policy to forget_farthest",
                    atoms);
  } else {
    status.summaryf(diagnostic_msgs::DiagnosticStatus::OK, "%zu atoms", atoms);
  }
  status.add("atoms", atoms);
  status.add("bytes", bytes);
  status.add("atoms refused", limits.refused);
  status.add("atoms forgotten", limits.forgotten);
  const atom_map::MappingParameters parameters = server.parameters();
  status.add("radius (m)", parameters.radius);
  status.add("mode", atom_map::map_file::nameOf(parameters.mode));
}

void describeMap(const BaselineServer& server, diagnostic_updater::DiagnosticStatusWrapper& status) {
  const auto [leaves, bytes, resolution] = server.read([](const atom_map::OctomapBaseline& map) {
    return std::make_tuple(map.tree().getNumLeafNodes(), map.bytes(), map.tree().getResolution());
  });
  status.summaryf(diagnostic_msgs::DiagnosticStatus::OK, "%zu leaves", leaves);
  status.add("leaves", leaves);
  status.add("bytes", bytes);
  status.add("resolution (m)", resolution);
}

NodeDiagnostics::NodeDiagnostics(const ros::NodeHandle& node, const CloudServer& server,
                                 const DescribeMap& describe_map)
    : server_(server), topic_(node.resolveName("cloud_in")), next_look_(Clock::now() + kLookPeriod) {
  updater_.setHardwareID("none");
  updater_.add("scans", this, &NodeDiagnostics::describeScans);
  updater_.add("map", describe_map);
  timer_ = node.createWallTimer(ros::WallDuration(kPeriod), [this](const auto& /*event*/) { updater_.force_update(); });
}

void NodeDiagnostics::noteScan(const ScanReport& report, double delay) {
  const std::lock_guard lock(mutex_);
  last_ = report;
  ++interval_.scans;
  interval_.longest_delay = std::max(interval_.longest_delay, delay);
  interval_.longest_mapping = std::max(interval_.longest_mapping, static_cast<double>(report.seconds_total));
}

void NodeDiagnostics::describeScans(Status& status) {
  Interval interval;
  {
    const std::lock_guard lock(mutex_);
    std::swap(interval, interval_);
  }
  const ScanCounts counts = server_.counts();
  const std::uint64_t dropped = counts.droppedInAll() - std::exchange(dropped_before_, counts.droppedInAll());
  const double seconds = std::chrono::duration<double>(Clock::now() - interval.start).count();
  const double rate = seconds > 0.0 ? interval.scans / seconds : 0.0;

  if (dropped > 0) {
    status.summaryf(Status::WARN, "%lu clouds dropped; the last: %s", dropped, counts.last_drop.c_str());
  } else if (counts.mapped == 0) {
    describeWaiting(status);
  } else {
    status.summaryf(Status::OK, "%.1f scans a second", rate);
  }
  status.addf("scan rate (Hz)", "%.2f", rate);
  status.addf("longest delay (s)", "%.3f", interval.longest_delay);
  status.addf("longest mapping (s)", "%.3f", interval.longest_mapping);
  status.add("mapped", counts.mapped);
  status.add("mapped: empty", counts.empty);
  for (std::size_t i = 0; i < kDropCauses; ++i) {
    status.add(std::string("dropped: ") + toString(static_cast<Drop>(i)), counts.dropped[i]);
  }
  status.add("last drop", counts.last_drop);
}

void NodeDiagnostics::describeWaiting(Status& status) {
  const auto now = Clock::now();
  ros::master::V_TopicInfo advertised;
  if (now >= next_look_ && ros::master::getTopics(advertised)) {
    const std::string found = describeSilence(topic_, advertised, ros::this_node::getName());
    if (found != silence_) ROS_WARN_STREAM("Nothing to map: " << found);
    silence_ = found;
    next_look_ = now + kLookPeriod;
  }
  silence_.empty() ? status.summary(Status::OK, "waiting for the first cloud") : status.summary(Status::WARN, silence_);
}

}  // namespace atom_mapping
