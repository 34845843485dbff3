// The main of every rostest's gtest, which takes its name in ROS from what starts it.
#include <gtest/gtest.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "node_test");
  ros::start();
  return RUN_ALL_TESTS();
}
