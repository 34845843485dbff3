#include "atom_mapping/ros/voxel_messages.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include "simulated_input.h"

namespace atom_mapping {
namespace {

using visualization_msgs::Marker;

class VoxelMessages : public testing::Test {
 protected:
  void SetUp() override {
    BaselineServer server{BaselineParameters()};
    const SimulatedDrive drive;
    tf2::BufferCore transforms;
    for (int i = 0; i < 2; ++i) {
      transforms.setTransform(drive.transform(i), "test");
      ASSERT_FALSE(server.insert(drive.cloud(i), transforms).drop);
    }
    map_ = takeSnapshot(server);
    server.read([&](const atom_map::OctomapBaseline& map) {
      for (auto leaf = map.tree().begin_leafs(); leaf != map.tree().end_leafs(); ++leaf) {
        occupied_ += map.tree().isNodeOccupied(*leaf) ? 1 : 0;
      }
    });
    stamp_ = drive.header(1, "").stamp;
  }

  VoxelSnapshot map_;
  std::size_t occupied_ = 0;
  ros::Time stamp_;
};

TEST_F(VoxelMessages, SnapshotHoldsEveryOccupiedVoxel) {
  EXPECT_EQ(map_.voxels.size(), occupied_);
  EXPECT_GT(occupied_, 500U);
  EXPECT_EQ(map_.frame, "map");
  EXPECT_EQ(map_.stamp, stamp_);
  EXPECT_EQ(map_.revision, 2U);
  EXPECT_EQ(map_.sides.size(), 17U);
  EXPECT_DOUBLE_EQ(map_.sides[16], atom_map::equalVolumeVoxel(0.25));
}

TEST_F(VoxelMessages, MarkersShowThemDepthByDepth) {
  map_.voxels.push_back({{1.0F, 2.0F, 100.0F}, 15});  // as where pruning joined eight
  const auto array = toMarkers(map_);
  ASSERT_EQ(array.markers.size(), 17U);
  for (std::size_t depth = 0; depth < array.markers.size(); ++depth) {
    const Marker& marker = array.markers[depth];
    EXPECT_EQ(marker.id, static_cast<int>(depth));
    EXPECT_EQ(marker.type, int{Marker::CUBE_LIST});
    EXPECT_EQ(marker.action, depth < 15 ? int{Marker::DELETE} : int{Marker::ADD});
    EXPECT_EQ(marker.colors.size(), marker.points.size());
    EXPECT_EQ(marker.scale.x, map_.sides[depth]);
    EXPECT_EQ(marker.header.frame_id, "map");
  }
  EXPECT_EQ(array.markers[16].points.size(), occupied_);
  ASSERT_EQ(array.markers[15].points.size(), 1U);
  EXPECT_EQ(array.markers[15].points[0].z, 100.0);
  EXPECT_GT(array.markers[15].colors[0].r, array.markers[16].colors[0].r) << "the highest is red";
}

TEST_F(VoxelMessages, TheCloudHoldsTheirCenters) {
  const auto cloud = toCenters(map_);
  EXPECT_EQ(cloud.width, occupied_);
  EXPECT_EQ(cloud.header.stamp, stamp_);
  sensor_msgs::PointCloud2ConstIterator<float> x(cloud, "x");
  for (const VoxelSnapshot::Voxel& voxel : map_.voxels) {
    ASSERT_EQ(Eigen::Vector3f(x[0], x[1], x[2]), voxel.center);
    ++x;
  }
}

TEST(VoxelMessagesOfAnEmptyMap, RemoveWhatWasShown) {
  const BaselineServer server{BaselineParameters()};
  const VoxelSnapshot map = takeSnapshot(server);
  for (const Marker& marker : toMarkers(map).markers) EXPECT_EQ(marker.action, int{Marker::DELETE});
  EXPECT_EQ(toCenters(map).width, 0U);
}

}  // namespace
}  // namespace atom_mapping
