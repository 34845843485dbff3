#include "atom_mapping/ros/cloud_silence.h"

#include <gtest/gtest.h>

namespace atom_mapping {
namespace {

const ros::master::TopicInfo kLidar("/velodyne_points", "sensor_msgs/PointCloud2");
const ros::master::TopicInfo kSecond("/rear/points", "sensor_msgs/PointCloud2");
const ros::master::TopicInfo kOwn("/atom_mapping/atoms_cloud", "sensor_msgs/PointCloud2");
const ros::master::TopicInfo kImage("/camera/image", "sensor_msgs/Image");

std::string silence(const ros::master::V_TopicInfo& advertised) {
  return describeSilence("/pionts", advertised, "/atom_mapping");
}

TEST(CloudSilence, TellsWhereThereAreClouds) {
  EXPECT_EQ(
      silence({kOwn, kLidar, kImage, kSecond}),
      "no cloud on /pionts yet, which nobody publishes; there are clouds on /rear/points, /velodyne_points: remap "
      "cloud_in, or give the launch file its cloud_topic");
}

TEST(CloudSilence, NamesNoOtherTopicWhereThereIsNoneOrTheTopicIsRight) {
  EXPECT_EQ(silence({kOwn, kImage}), "no cloud on /pionts yet, which nobody publishes");
  EXPECT_EQ(silence({kLidar, {"/pionts", "sensor_msgs/PointCloud2"}}), "no cloud on /pionts yet");
}

}  // namespace
}  // namespace atom_mapping
