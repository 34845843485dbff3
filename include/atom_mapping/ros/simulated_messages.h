// Simulated scans as the messages that a real robot's drivers publish.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>

#include <string>

#include "atom_mapping/sim/simulate_scan.h"

namespace atom_map {

// The returns in the layout of velodyne_pointcloud's PointXYZIRT: x y z intensity ring time, 22 bytes a point, dense.
sensor_msgs::PointCloud2 toPointCloud2(const SimulatedScan& scan, const std_msgs::Header& header);

// The same layout with one row a ring (row 0 the lowest) and one column a firing. A ray without an echo has +Inf in all
// of its coordinates (REP 117), so its direction is lost; the cloud is not dense.
sensor_msgs::PointCloud2 toOrganizedPointCloud2(const SimulatedScan& scan, const LidarModel& model,
                                                const std_msgs::Header& header);

// `pose` brings `child_frame` to the header's frame.
geometry_msgs::TransformStamped toTransformStamped(const Pose& pose, const std_msgs::Header& header,
                                                   const std::string& child_frame);

}  // namespace atom_map
