#include "atom_mapping/ros/voxel_messages.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>

#include "atom_mapping/ros/atom_colors.h"
#include "atom_mapping/ros/pose_conversion.h"

namespace atom_mapping {
namespace {

using visualization_msgs::Marker;
using Voxel = VoxelSnapshot::Voxel;

constexpr float kMinHeight = 1e-3F;  // m

std_msgs::Header makeHeader(const VoxelSnapshot& map) {
  std_msgs::Header header;
  header.frame_id = map.frame;
  header.stamp = map.stamp;
  return header;
}

Marker makeCubes(const VoxelSnapshot& map, std::size_t depth) {
  Marker marker;
  marker.header = makeHeader(map);
  marker.ns = map.frame;
  marker.id = static_cast<int>(depth);
  marker.type = Marker::CUBE_LIST;
  marker.action = Marker::DELETE;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = map.sides[depth];
  marker.color.a = 1.0F;
  return marker;
}

void addCube(const Eigen::Vector3f& center, float height, Marker& marker) {
  marker.action = Marker::ADD;
  marker.points.push_back(toPoint(center.cast<double>()));
  marker.colors.push_back(colorOf(height));
}

}  // namespace

VoxelSnapshot takeSnapshot(const BaselineServer& server) {
  VoxelSnapshot snapshot;
  snapshot.frame = server.mapFrame();
  snapshot.stamp = server.newest();
  snapshot.revision = server.revision();
  server.read([&](const atom_map::OctomapBaseline& map) {
    const octomap::OcTree& tree = map.tree();
    for (unsigned depth = 0; depth <= tree.getTreeDepth(); ++depth) snapshot.sides.push_back(tree.getNodeSize(depth));
    const auto end = tree.end_leafs();
    for (auto leaf = tree.begin_leafs(); leaf != end; ++leaf) {
      if (!tree.isNodeOccupied(*leaf)) continue;
      const octomap::point3d center = leaf.getCoordinate();
      snapshot.voxels.push_back({{center.x(), center.y(), center.z()}, leaf.getDepth()});
    }
  });
  return snapshot;
}

visualization_msgs::MarkerArray toMarkers(const VoxelSnapshot& map) {
  visualization_msgs::MarkerArray array;
  for (std::size_t depth = 0; depth < map.sides.size(); ++depth) array.markers.push_back(makeCubes(map, depth));
  const auto [low, high] = std::minmax_element(
      map.voxels.begin(), map.voxels.end(), [](const Voxel& a, const Voxel& b) { return a.center.z() < b.center.z(); });
  for (const Voxel& voxel : map.voxels) {
    const float range = std::max(high->center.z() - low->center.z(), kMinHeight);
    addCube(voxel.center, (voxel.center.z() - low->center.z()) / range, array.markers[voxel.depth]);
  }
  return array;
}

sensor_msgs::PointCloud2 toCenters(const VoxelSnapshot& map) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header = makeHeader(map);
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2Fields(3, "x", 1, sensor_msgs::PointField::FLOAT32, "y", 1, sensor_msgs::PointField::FLOAT32,
                                "z", 1, sensor_msgs::PointField::FLOAT32);
  modifier.resize(map.voxels.size());
  cloud.is_dense = 1;
  sensor_msgs::PointCloud2Iterator<float> x(cloud, "x");
  for (const Voxel& voxel : map.voxels) {
    std::copy_n(voxel.center.data(), 3, &*x);
    ++x;
  }
  return cloud;
}

}  // namespace atom_mapping
