// What the tests feed the server and the node with: a simulated lidar in the hall, and clouds with a fault.
#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/PointCloud2.h>

#include <functional>
#include <string>
#include <vector>

#include "atom_mapping/ros/simulated_messages.h"
#include "atom_mapping/sim/make_scene.h"
#include "atom_mapping/sim/simulate_scan.h"

namespace atom_mapping {

// Scan i of a drive through the hall: ten a second from kStart on.
struct SimulatedDrive {
  static constexpr std::uint32_t kStart = 1500000000;  // s

  atom_map::Scene scene = atom_map::makeScene("hall");
  atom_map::Trajectory trajectory = atom_map::makeTrajectory("hall");
  atom_map::LidarModel model;

  std_msgs::Header header(int i, const std::string& frame) const {
    std_msgs::Header header;
    header.frame_id = frame;
    header.stamp = ros::Time(kStart, 0) + ros::Duration().fromNSec(std::int64_t{100000000} * i);
    return header;
  }

  atom_map::SimulatedScan scan(int i) const { return atom_map::simulateScan(scene, trajectory, 0.1 * i, model, 1); }

  atom_map::Pose pose(int i) const { return trajectory.sensorPose(0.1 * i); }

  sensor_msgs::PointCloud2 cloud(int i) const { return atom_map::toPointCloud2(scan(i), header(i, "velodyne")); }

  geometry_msgs::TransformStamped transform(int i) const {
    return atom_map::toTransformStamped(pose(i), header(i, "map"), "velodyne");
  }
};

// A coarse sensor, where only few points are needed.
inline SimulatedDrive makeCoarseDrive() {
  SimulatedDrive drive;
  drive.model.firings = 180;
  return drive;
}

struct Fault {
  const char* name;
  std::function<void(sensor_msgs::PointCloud2&)> spoil;
};

// Each makes a good cloud malformed.
inline std::vector<Fault> malformations() {
  return {{"no x", [](auto& c) { c.fields.erase(c.fields.begin()); }},
          {"x as double", [](auto& c) { c.fields[0].datatype = sensor_msgs::PointField::FLOAT64; }},
          {"point_step too small", [](auto& c) { c.point_step = 10; }},
          {"row_step too large", [](auto& c) { ++c.row_step; }},
          {"row_step of zero", [](auto& c) { c.row_step = 0; }},
          {"data cut short", [](auto& c) { c.data.resize(c.data.size() / 2); }},
          {"no data", [](auto& c) { c.data.clear(); }},
          {"a width of 4 billion", [](auto& c) { c.width = 4000000000U; }},
          {"no frame", [](auto& c) { c.header.frame_id.clear(); }},
          {"a frame of nothing but a slash", [](auto& c) { c.header.frame_id = "/"; }},
          {"a frame of two slashes", [](auto& c) { c.header.frame_id = "//velodyne"; }},
          {"no stamp", [](auto& c) { c.header.stamp = ros::Time(); }},
          {"a stamp at the end of time", [](auto& c) { c.header.stamp = ros::Time(0xFFFFFFFFU, 999999999U); }},
          {"a stamp of too many nanoseconds", [](auto& c) { c.header.stamp.nsec = 0xFFFFFFFFU; }}};
}

}  // namespace atom_mapping
