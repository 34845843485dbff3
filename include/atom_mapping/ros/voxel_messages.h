#pragma once

#include <ros/time.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "atom_mapping/ros/baseline_server.h"

namespace atom_mapping {

// A copy of OctoMap's occupied voxels, to be turned into messages while mapping goes on.
struct VoxelSnapshot {
  struct Voxel {
    Eigen::Vector3f center;  // map frame
    unsigned depth;          // in the tree: with pruning, some are larger than others
  };

  std::string frame;
  ros::Time stamp;  // of the newest scan in it
  std::uint64_t revision;
  std::vector<double> sides;  // m, of a voxel of each depth
  std::vector<Voxel> voxels;
};

VoxelSnapshot takeSnapshot(const BaselineServer& server);

// As octomap_server publishes them: a CUBE_LIST for each depth of the tree, coloured by height; DELETE where it has none.
visualization_msgs::MarkerArray toMarkers(const VoxelSnapshot& map);

// Their centers: x y z.
sensor_msgs::PointCloud2 toCenters(const VoxelSnapshot& map);

}  // namespace atom_mapping
