#include "atom_mapping/ros/path_service.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "simulated_input.h"

namespace atom_mapping {
namespace {

using Eigen::Vector3d;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

geometry_msgs::PoseStamped place(const Vector3d& p, const std::string& frame = "") {
  geometry_msgs::PoseStamped pose;
  pose.header.frame_id = frame;
  pose.pose.position.x = p.x();
  pose.pose.position.y = p.y();
  pose.pose.position.z = p.z();
  return pose;
}

PlanPath::Request ask(const Vector3d& start, const Vector3d& goal, const std::string& frame = "") {
  PlanPath::Request request;
  request.start = place(start, frame);
  request.goal = place(goal, frame);
  request.robot_radius = 0.3F;
  return request;
}

Vector3d positionOf(const geometry_msgs::PoseStamped& pose) {
  return {pose.pose.position.x, pose.pose.position.y, pose.pose.position.z};
}

// Where the pose looks, in the path's frame.
Vector3d forward(const geometry_msgs::PoseStamped& pose) {
  const auto& q = pose.pose.orientation;
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Vector3d::UnitX();
}

class PathServiceTest : public testing::Test {
 protected:
  void SetUp() override {
    for (int i = 0; i < kScans; ++i) {
      transforms_.setTransform(drive_.transform(i), "test");
      server_.insert(drive_.cloud(i), transforms_);
    }
  }

  static Vector3d inMap(const Vector3d& in_sensor) { return SimulatedDrive().pose(kScans - 1) * in_sensor; }

  void expectRefused(const PlanPath::Response& response, const std::string& message) {
    EXPECT_FALSE(response.success);
    EXPECT_NE(response.message.find(message), std::string::npos) << response.message;
    EXPECT_TRUE(response.path.poses.empty());
  }

  static constexpr int kScans = 10;
  static inline const Vector3d kAhead{5.0, 0.0, 0.0};  // free, sensor frame
  SimulatedDrive drive_;
  tf2::BufferCore transforms_;
  ScanServer server_{atom_map::MappingParameters()};
  PathService service_{server_, transforms_};
};

TEST_F(PathServiceTest, APathLeadsFromStartToGoalAndLooksAhead) {
  auto request = ask(inMap(Vector3d::Zero()), inMap(kAhead));
  const auto response = service_.answer(request);
  ASSERT_TRUE(response.success) << response.message;
  const auto& poses = response.path.poses;
  EXPECT_EQ(response.path.header.frame_id, "map");
  EXPECT_EQ(response.path.header.stamp, drive_.header(kScans - 1, "").stamp);
  EXPECT_LT((positionOf(poses.front()) - inMap(Vector3d::Zero())).norm(), 1e-4);
  EXPECT_LT((positionOf(poses.back()) - inMap(kAhead)).norm(), 1e-4);
  double length = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Vector3d way = positionOf(poses[i]) - positionOf(poses[i - 1]);
    length += way.norm();
    EXPECT_NEAR(forward(poses[i - 1]).dot(way.normalized()), 1.0, 1e-6);
    EXPECT_GT(drive_.scene.signedDistance(positionOf(poses[i])), 0.3 - 0.125);
  }
  EXPECT_NEAR(response.length, length, 1e-4);
  EXPECT_NEAR(response.cost, length, 1e-4);
  EXPECT_LT(length, 5.5);
  EXPECT_GT(response.expanded, 2U);
}

TEST_F(PathServiceTest, TheGoalsOrientationIsTheLast) {
  auto request = ask(Vector3d::Zero(), kAhead, "velodyne");
  request.goal.pose.orientation.z = 1.0;  // half a turn about the sensor's z axis
  const auto response = service_.answer(request);
  ASSERT_TRUE(response.success) << response.message;
  const Vector3d expected = drive_.pose(kScans - 1).linear() * -Vector3d::UnitX();
  EXPECT_NEAR(forward(response.path.poses.back()).dot(expected), 1.0, 1e-6);
}

TEST_F(PathServiceTest, StartAndGoalMayBeInFramesOfTheirOwn) {
  auto request = ask(Vector3d::Zero(), kAhead, "velodyne");
  const auto in_sensor = service_.answer(request);
  request.start = place(inMap(Vector3d::Zero()), "/map");
  const auto mixed = service_.answer(request);
  ASSERT_TRUE(in_sensor.success && mixed.success) << in_sensor.message << mixed.message;
  EXPECT_EQ(mixed.path.header.frame_id, "map");
  EXPECT_NEAR(in_sensor.length, mixed.length, 1e-3);
  EXPECT_LT((positionOf(in_sensor.path.poses.back()) - inMap(kAhead)).norm(), 1e-4);
}

TEST_F(PathServiceTest, ASurfaceTermCostsMore) {
  auto request = ask(inMap(Vector3d::Zero()), inMap(kAhead));
  request.surface_distance = 0.8F;
  request.surface_weight = 2.0F;
  const auto response = service_.answer(request);
  ASSERT_TRUE(response.success) << response.message;
  EXPECT_GT(response.cost, 1.02F * response.length);
  EXPECT_GE(response.length, 0.999F * service_.answer(ask(inMap(Vector3d::Zero()), inMap(kAhead))).length);
}

TEST_F(PathServiceTest, FaultyRequestsAreRefusedWithTheReason) {
  const Vector3d here = inMap(Vector3d::Zero());
  expectRefused(service_.answer(ask(Vector3d(kNan, 0, 0), here)), "start.pose.position is (");
  expectRefused(service_.answer(ask(here, Vector3d(0, 1e300, 0))), "goal.pose.position is (");
  expectRefused(service_.answer(ask(here, here, "nowhere")), "nowhere");
  auto request = ask(here, inMap(kAhead));
  request.robot_radius = -1.0F;
  expectRefused(service_.answer(request), "robot_radius is -1");
  request.robot_radius = 9.0F;
  expectRefused(service_.answer(request), "robot_radius is 9.000000; it must be at most 8");
  request = ask(here, inMap(kAhead));
  request.surface_distance = std::nanf("");
  expectRefused(service_.answer(request), "surface_distance is nan");
  request = ask(here, inMap(kAhead));
  request.surface_weight = std::numeric_limits<float>::infinity();
  expectRefused(service_.answer(request), "surface_weight is inf");
  request = ask(here, inMap(kAhead));
  request.timeout = -1.0F;
  expectRefused(service_.answer(request), "timeout is -1");
}

TEST_F(PathServiceTest, RefusalsSayWhyThereIsNoPath) {
  const Vector3d here = inMap(Vector3d::Zero());
  expectRefused(service_.answer(ask(here, Vector3d(0, 0, 100))), "goal (0.00, 0.00, 100.00) is unknown");
  expectRefused(service_.answer(ask(Vector3d(0, 0, 100), here)), "start (0.00, 0.00, 100.00) is unknown");
  Vector3d wall = here;
  for (const auto& echo : drive_.scan(kScans - 1).returns) {
    if (std::abs(echo.point.norm() - 8.0F) < 1.0F) wall = inMap(1.03 * echo.true_point.cast<double>());
  }
  expectRefused(service_.answer(ask(here, wall)), "is occupied");
  auto request = ask(here, inMap(kAhead));
  request.robot_radius = 3.0F;
  expectRefused(service_.answer(request), "is too tight");
  request = ask(here, inMap(kAhead));
  request.timeout = 1e-6F;
  expectRefused(service_.answer(request), "no path in time");
  server_.clearRegion({inMap(kAhead) + Vector3d(-2, -2, -40), inMap(kAhead) + Vector3d(2, 2, 40)});
  expectRefused(service_.answer(ask(here, inMap(kAhead))), "is unknown");
}

TEST_F(PathServiceTest, AGoalStartsAtTheSensorAndHasNoHeight) {
  const auto in_space = service_.answerGoal(place(kAhead, "velodyne"));
  ASSERT_TRUE(in_space.success) << in_space.message;
  EXPECT_LT((positionOf(in_space.path.poses.front()) - inMap(Vector3d::Zero())).norm(), 1e-4);
  Vector3d on_floor = inMap(kAhead);
  on_floor.z() = 0.0;
  const auto lifted = service_.answerGoal(place(on_floor, "map"));
  ASSERT_TRUE(lifted.success) << lifted.message;
  const Vector3d end = positionOf(lifted.path.poses.back());
  EXPECT_LT((end - on_floor).head<2>().norm(), 1e-4);
  EXPECT_NEAR(end.z(), inMap(Vector3d::Zero()).z(), 0.5);
  expectRefused(service_.answerGoal(place(Vector3d(300, 0, 0))), "is unknown");
  const ScanServer empty{atom_map::MappingParameters()};
  expectRefused(PathService(empty, transforms_).answerGoal(place(on_floor)), "no cloud has been mapped yet");
}

TEST_F(PathServiceTest, PlanningDoesNotHoldUpMapping) {
  std::atomic<bool> stop{false};
  std::atomic<int> planned{0};
  std::thread planner([&] {
    while (!stop) planned += service_.answer(ask(inMap(Vector3d::Zero()), inMap(kAhead))).success ? 1 : 0;
  });
  const auto start = std::chrono::steady_clock::now();
  for (int i = kScans; i < 2 * kScans; ++i) {
    transforms_.setTransform(drive_.transform(i), "test");
    EXPECT_FALSE(server_.insert(drive_.cloud(i), transforms_).drop);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  stop = true;
  planner.join();
  EXPECT_GT(planned, 0);
  EXPECT_LT(seconds, 5.0);
  RecordProperty("milliseconds_a_scan", static_cast<int>(1000.0 * seconds / kScans));
}

}  // namespace
}  // namespace atom_mapping
