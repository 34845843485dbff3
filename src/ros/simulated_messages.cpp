#include "atom_mapping/ros/simulated_messages.h"

#include <sensor_msgs/PointField.h>
#include <sensor_msgs/point_cloud2_iterator.h>
#include <tf2_eigen/tf2_eigen.h>

#include <cstring>
#include <limits>

namespace atom_map {
namespace {

using sensor_msgs::PointField;

sensor_msgs::PointCloud2 makeCloud(std::size_t rows, std::size_t columns, const std_msgs::Header& header) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header = header;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2Fields(6, "x", 1, PointField::FLOAT32, "y", 1, PointField::FLOAT32, "z", 1,
                                PointField::FLOAT32, "intensity", 1, PointField::FLOAT32, "ring", 1, PointField::UINT16,
                                "time", 1, PointField::FLOAT32);
  modifier.resize(rows * columns);
  cloud.height = static_cast<std::uint32_t>(rows);
  cloud.width = static_cast<std::uint32_t>(columns);
  cloud.row_step = cloud.width * cloud.point_step;
  return cloud;
}

template <typename Value>
std::uint8_t* put(std::uint8_t* at, Value value) {
  std::memcpy(at, &value, sizeof(value));  // the fields after `ring` are not aligned
  return at + sizeof(value);
}

void putPoint(sensor_msgs::PointCloud2& cloud, std::size_t index, const Eigen::Vector3f& point, float intensity,
              std::uint16_t ring, float time) {
  std::uint8_t* at = cloud.data.data() + index * cloud.point_step;
  for (const float coordinate : {point.x(), point.y(), point.z(), intensity}) at = put(at, coordinate);
  at = put(at, ring);
  put(at, time);
}

}  // namespace

sensor_msgs::PointCloud2 toPointCloud2(const SimulatedScan& scan, const std_msgs::Header& header) {
  sensor_msgs::PointCloud2 cloud = makeCloud(1, scan.returns.size(), header);
  cloud.is_dense = true;
  for (std::size_t i = 0; i < scan.returns.size(); ++i) {
    const SimulatedReturn& r = scan.returns[i];
    putPoint(cloud, i, r.point, r.intensity, r.ring, r.time);
  }
  return cloud;
}

sensor_msgs::PointCloud2 toOrganizedPointCloud2(const SimulatedScan& scan, const LidarModel& model,
                                                const std_msgs::Header& header) {
  const auto columns = static_cast<std::size_t>(model.firings);
  sensor_msgs::PointCloud2 cloud = makeCloud(static_cast<std::size_t>(model.rings), columns, header);
  cloud.is_dense = false;
  const Eigen::Vector3f nowhere = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
  for (const SimulatedReturn& r : scan.returns) {
    putPoint(cloud, r.ring * columns + r.firing, r.point, r.intensity, r.ring, r.time);
  }
  for (const SimulatedNoReturn& r : scan.no_returns) {
    putPoint(cloud, r.ring * columns + r.firing, nowhere, 0.0F, r.ring, r.time);
  }
  return cloud;
}

geometry_msgs::TransformStamped toTransformStamped(const Pose& pose, const std_msgs::Header& header,
                                                   const std::string& child_frame) {
  geometry_msgs::TransformStamped transform = tf2::eigenToTransform(pose);
  transform.header = header;
  transform.child_frame_id = child_frame;
  return transform;
}

}  // namespace atom_map
