#include "atom_mapping/ros/cloud_server.h"

#include <sstream>
#include <stdexcept>

#include "atom_mapping/ros/cloud_conversion.h"
#include "atom_mapping/ros/frame_name.h"
#include "atom_mapping/ros/header_fault.h"
#include "atom_mapping/ros/pose_conversion.h"
#include "atom_mapping/ros/scan_report_message.h"

namespace atom_mapping {
namespace {

class OutOfOrder : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace

CloudServer::CloudServer(const std::string& map_frame, bool infer_no_returns)
    : map_frame_(withoutSlash(map_frame)), infer_no_returns_(infer_no_returns) {}

ScanOutcome CloudServer::insert(const sensor_msgs::PointCloud2& cloud, const tf2::BufferCore& transforms) {
  const ros::Time& stamp = cloud.header.stamp;
  const std::string frame = withoutSlash(cloud.header.frame_id);
  try {
    if (const auto fault = headerFault(cloud.header)) throw MalformedCloud(*fault);
    const auto scan = toLidarScan(cloud, infer_no_returns_);
    const std::uint64_t era = checkOrder(stamp);
    const auto pose = toPose(transforms.lookupTransform(map_frame_, frame, stamp).transform);
    const atom_map::ScanReport report = insertScan(scan, pose);
    noteMapped(stamp, era, pose, scan.points.empty());
    return {std::nullopt, "", toMessage(report, cloud.header)};
  } catch (const MalformedCloud& fault) {
    return drop(Drop::kMalformed, std::string("malformed cloud: ") + fault.what());
  } catch (const OutOfOrder& fault) {
    return drop(Drop::kOutOfOrder, fault.what());
  } catch (const BadTransform& fault) {
    return drop(Drop::kBadTransform, "bad transform from " + frame + " to " + map_frame_ + ": " + fault.what());
  } catch (const std::runtime_error& fault) {  // tf2::TransformException, and of stamps too far apart to subtract
    return drop(Drop::kNoTransform, "no transform from " + frame + " to " + map_frame_ + ": " + fault.what());
  }
}

ScanOutcome CloudServer::drop(Drop cause, const std::string& message) {
  const std::lock_guard lock(mutex_);
  ++counts_.dropped[static_cast<std::size_t>(cause)];
  counts_.last_drop = message;
  return {cause, message, {}};
}

void CloudServer::restartTime() {
  const std::lock_guard lock(mutex_);
  newest_ = ros::Time();
  ++era_;
}

ScanCounts CloudServer::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

std::uint64_t CloudServer::revision() const {
  const std::lock_guard lock(mutex_);
  return revision_;
}

ros::Time CloudServer::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

std::optional<atom_map::Pose> CloudServer::sensorPose() const {
  const std::lock_guard lock(mutex_);
  return sensor_pose_;
}

// The era that the stamp is of.
std::uint64_t CloudServer::checkOrder(const ros::Time& stamp) const {
  const std::lock_guard lock(mutex_);
  if (stamp >= newest_) return era_;
  std::ostringstream fault;
  fault << "out of order: its stamp " << stamp << " lies before " << newest_ << ", that of a cloud in the map";
  throw OutOfOrder(fault.str());
}

void CloudServer::noteMapped(const ros::Time& stamp, std::uint64_t era, const atom_map::Pose& sensor, bool is_empty) {
  const std::lock_guard lock(mutex_);
  ++counts_.mapped;
  counts_.empty += is_empty ? 1 : 0;
  sensor_pose_ = sensor;
  if (era == era_) newest_ = stamp;  // else time began anew while the cloud was being merged
  ++revision_;
}

void CloudServer::noteChange() {
  const std::lock_guard lock(mutex_);
  ++revision_;
}

}  // namespace atom_mapping
