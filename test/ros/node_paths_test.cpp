// Paths through the node: asked for by service and by goal, shown on ~path.
#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Path.h>

#include "atom_mapping/PlanPath.h"
#include "node_client.h"

namespace atom_mapping {
namespace {

using Eigen::Vector3d;

constexpr int kScans = 10;

geometry_msgs::PoseStamped place(const Vector3d& point, const std::string& frame) {
  geometry_msgs::PoseStamped pose;
  pose.header.frame_id = frame;
  pose.pose.position = toPoint(point);
  return pose;
}

// Free, and above what a drive of one second has seen.
const Vector3d kAhead(5.0, 0.0, 0.0);

void expectSafe(const SimulatedDrive& drive, const nav_msgs::Path& path) {
  ASSERT_GE(path.poses.size(), 2U);
  for (std::size_t i = 1; i < path.poses.size(); ++i) {
    const Vector3d from = toVector(path.poses[i - 1].pose.position);
    const Vector3d way = toVector(path.poses[i].pose.position) - from;
    for (int k = 0; k <= 20; ++k) EXPECT_GE(drive.scene.signedDistance(from + 0.05 * k * way), 0.3 - 0.125);
  }
}

TEST(NodePaths, ServiceAndGoalPlanAndShowPaths) {
  NodeClient client;
  ros::NodeHandle node;
  auto goals = node.advertise<geometry_msgs::PoseStamped>("/goal", 10);
  ASSERT_TRUE(client.waitForNode());
  ASSERT_TRUE(NodeClient::waitUntil([&] { return goals.getNumSubscribers() > 0; }));
  const SimulatedDrive drive;
  goals.publish(place(kAhead, "map"));
  client.expectOneWarning("no cloud has been mapped yet");
  for (int i = 0; i < kScans; ++i) {
    client.publish(drive.transform(i));
    client.publish(drive.cloud(i));
  }
  ASSERT_TRUE(client.waitForReports(kScans));

  PlanPath::Request request;
  request.start = place(Vector3d::Zero(), "velodyne");
  request.goal = place(kAhead, "velodyne");
  request.robot_radius = 0.3F;
  const auto response = NodeClient::call<PlanPath>("plan_path", request);
  ASSERT_TRUE(response.success) << response.message;
  expectSafe(drive, response.path);
  EXPECT_NEAR(response.length, 5.0, 0.5);
  const auto shown = client.receive<nav_msgs::Path>("/atom_mapping/path");
  EXPECT_EQ(shown.poses.size(), response.path.poses.size());

  const Vector3d sideways = drive.pose(kScans - 1) * Vector3d(4.0, 2.0, 0.0);
  goals.publish(place({sideways.x(), sideways.y(), 0.0}, "map"));  // as rviz's 2D Nav Goal
  const auto by_goal = client.receive<nav_msgs::Path>("/atom_mapping/path", [&](const nav_msgs::Path& path) {
    return (toVector(path.poses.back().pose.position) - sideways).head<2>().norm() < 1e-3;
  });
  expectSafe(drive, by_goal);
  EXPECT_LT((toVector(by_goal.poses.front().pose.position) - drive.pose(kScans - 1).translation()).norm(), 1e-3);

  request.goal = place({0.0, 0.0, 100.0}, "map");
  const auto refused = NodeClient::call<PlanPath>("plan_path", request);
  EXPECT_FALSE(refused.success);
  EXPECT_NE(refused.message.find("is unknown"), std::string::npos) << refused.message;
}

}  // namespace
}  // namespace atom_mapping
