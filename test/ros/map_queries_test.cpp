#include "atom_mapping/ros/map_queries.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

#include "atom_mapping/query/collision.h"
#include "atom_mapping/ros/answer_request.h"
#include "atom_mapping/ros/pose_conversion.h"
#include "simulated_input.h"

namespace atom_mapping {
namespace {

using Eigen::Vector3d;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

geometry_msgs::Vector3 toVector(const Vector3d& v) {
  geometry_msgs::Vector3 vector;
  vector.x = v.x();
  vector.y = v.y();
  vector.z = v.z();
  return vector;
}

template <class Request>
Request inFrame(const std::string& frame) {
  Request request;
  request.frame_id = frame;
  return request;
}

QueryOccupancy::Request askAt(const std::vector<Vector3d>& points, const std::string& frame = "") {
  auto request = inFrame<QueryOccupancy::Request>(frame);
  for (const Vector3d& point : points) request.points.push_back(toPoint(point));
  return request;
}

CheckCollision::Request sphere(const Vector3d& center, float radius, bool unknown_is_free = false) {
  CheckCollision::Request request;
  request.centers.push_back(toPoint(center));
  request.radii.push_back(radius);
  request.unknown_is_free = unknown_is_free ? 1 : 0;
  return request;
}

CastRay::Request ray(const Vector3d& origin, const Vector3d& direction, float max_range) {
  CastRay::Request request;
  request.origins.push_back(toPoint(origin));
  request.directions.push_back(toVector(direction));
  request.max_range = max_range;
  return request;
}

ClearRegion::Request box(const Vector3d& min, const Vector3d& max) {
  ClearRegion::Request request;
  request.min = toPoint(min);
  request.max = toPoint(max);
  return request;
}

class MapQueriesTest : public testing::Test {
 protected:
  void mapScans(int count) {
    for (int i = 0; i < count; ++i) {
      transforms_.setTransform(drive_.transform(i), "test");
      server_.insert(drive_.cloud(i), transforms_);
    }
  }

  template <class Request>
  void expectRefused(const Request& request, const std::string& message) {
    const std::uint64_t revision = server_.revision();
    const auto response = queries_.answer(request);
    EXPECT_FALSE(response.success);
    EXPECT_NE(response.message.find(message), std::string::npos) << response.message;
    EXPECT_EQ(server_.revision(), revision);
  }

  SimulatedDrive drive_;
  tf2::BufferCore transforms_;
  ScanServer server_{atom_map::MappingParameters()};
  ServiceParameters parameters_{1000};
  MapQueries queries_{server_, transforms_, parameters_};
};

TEST_F(MapQueriesTest, BeforeTheFirstScanEverythingIsUnknown) {
  const auto occupancy = queries_.answer(askAt({Vector3d::Zero(), Vector3d(1e7, 0, 0)}));
  EXPECT_TRUE(occupancy.success);
  EXPECT_EQ(occupancy.state, (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(occupancy.probability, (std::vector<float>{0.5F, 0.5F}));
  EXPECT_EQ(queries_.answer(sphere(Vector3d::Zero(), 1.0F)).collides[0], 1);
  EXPECT_EQ(queries_.answer(sphere(Vector3d::Zero(), 1.0F, true)).collides[0], 0);
  EXPECT_EQ(queries_.answer(ray(Vector3d::Zero(), Vector3d::UnitX(), 5.0F)).result[0], int{CastRay::Response::UNKNOWN});
  EXPECT_EQ(queries_.answer(box(-Vector3d::Ones(), Vector3d::Ones())).removed, 0U);
  EXPECT_TRUE(queries_.reset().success);
}

TEST_F(MapQueriesTest, NoPointsGetNoAnswers) {
  for (const auto& response : {queries_.answer(askAt({}))}) EXPECT_TRUE(response.success && response.state.empty());
  EXPECT_TRUE(queries_.answer(CheckCollision::Request()).success);
  EXPECT_TRUE(queries_.answer(CastRay::Request()).success);
}

TEST_F(MapQueriesTest, AnswersAgreeWithTheScene) {
  mapScans(10);
  std::vector<Vector3d> free_points;
  CastRay::Request rays;
  std::vector<double> ranges;
  rays.max_range = 20.0F;
  const Vector3d sensor = drive_.pose(9).translation();
  for (const auto& echo : drive_.scan(9).returns) {
    const Vector3d end = drive_.pose(9) * echo.true_point.cast<double>();
    const double range = (end - sensor).norm();
    if (range < 2.0 || range > 12.0) continue;
    free_points.push_back(sensor + 0.5 * (end - sensor));
    rays.origins.push_back(toPoint(free_points.back()));
    rays.directions.push_back(toVector(7.0 * (end - sensor)));
    ranges.push_back(0.5 * range);
    if (free_points.size() == 1000) break;
  }
  const auto occupancy = queries_.answer(askAt(free_points));
  const auto cast = queries_.answer(rays);
  ASSERT_TRUE(occupancy.success && cast.success);
  int free = 0;
  int ended = 0;  // the other rays met a hole that so few rings leave at this radius
  int hit_where_true = 0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    free += occupancy.state[i] == QueryOccupancy::Response::FREE ? 1 : 0;
    EXPECT_EQ(occupancy.state[i] == QueryOccupancy::Response::FREE, occupancy.probability[i] < 0.5F);
    const double length = std::hypot(cast.ends[i].x - free_points[i].x(), cast.ends[i].y - free_points[i].y(),
                                     cast.ends[i].z - free_points[i].z());
    if (cast.result[i] == CastRay::Response::UNKNOWN) continue;
    ++ended;
    hit_where_true += cast.result[i] == CastRay::Response::HIT && std::abs(length - ranges[i]) < 1.0 ? 1 : 0;
  }
  EXPECT_GT(free, 960);
  EXPECT_GT(ended, 600);
  EXPECT_GT(hit_where_true, ended * 9 / 10);
}

TEST_F(MapQueriesTest, PointsMayBeInAnyFrameThatTfKnows) {
  mapScans(3);
  const atom_map::Pose pose = drive_.pose(2);
  std::vector<Vector3d> in_sensor;
  std::vector<Vector3d> in_map;
  for (int i = 0; i < 200; ++i) {
    in_sensor.emplace_back(2.0 + 0.1 * i, std::sin(i), 0.3 * std::cos(3.0 * i));
    in_map.push_back(pose * in_sensor.back());
  }
  const auto here = queries_.answer(askAt(in_sensor, "velodyne"));
  EXPECT_TRUE(here.success) << here.message;
  for (const char* frame : {"", "map", "/map"}) EXPECT_EQ(queries_.answer(askAt(in_map, frame)).state, here.state);
  auto cast = ray(in_sensor[3], Vector3d(1.0, 0.2, 0.1), 8.0F);
  const auto in_map_frame = queries_.answer(ray(in_map[3], pose.linear() * Vector3d(1.0, 0.2, 0.1), 8.0F));
  cast.frame_id = "velodyne";
  const auto in_sensor_frame = queries_.answer(cast);
  ASSERT_TRUE(in_sensor_frame.success && in_map_frame.success);
  EXPECT_EQ(in_sensor_frame.result, in_map_frame.result);
  const auto& a = in_sensor_frame.ends[0];
  const auto& b = in_map_frame.ends[0];
  EXPECT_LT((pose * Vector3d(a.x, a.y, a.z) - Vector3d(b.x, b.y, b.z)).norm(), 1e-3);
}

TEST_F(MapQueriesTest, FaultyRequestsAreRefusedWithTheReason) {
  mapScans(1);
  expectRefused(askAt({Vector3d::Zero(), Vector3d(0, kNan, 0)}), "points[1] is (");
  expectRefused(askAt({Vector3d(0, 0, -kInfinity)}), "points[0] is (");
  expectRefused(askAt({Vector3d(1e300, 0, 0)}), "must be numbers within");
  expectRefused(askAt({Vector3d::Zero()}, "nowhere"), "nowhere");
  expectRefused(askAt(std::vector<Vector3d>(1001, Vector3d::Zero())), "services/max_points permits 1000");

  auto unequal = sphere(Vector3d::Zero(), 1.0F);
  unequal.radii.push_back(1.0F);
  expectRefused(unequal, "centers has 1 elements and radii has 2");
  expectRefused(sphere(Vector3d(kNan, 0, 0), 1.0F), "centers[0]");
  expectRefused(sphere(Vector3d::Zero(), -0.1F), "radii[0] is -0.1");
  expectRefused(sphere(Vector3d::Zero(), std::nanf("")), "radii[0] is");
  expectRefused(sphere(Vector3d::Zero(), 9.0F), "at most 8");
  EXPECT_TRUE(queries_.answer(sphere(Vector3d::Zero(), 9.0F, true)).success);

  auto no_direction = ray(Vector3d::Zero(), Vector3d::UnitX(), 1.0F);
  no_direction.directions.clear();
  expectRefused(no_direction, "origins has 1 elements and directions has 0");
  expectRefused(ray(Vector3d::Zero(), Vector3d::Zero(), 1.0F), "directions[0] is (0 0 0)");
  expectRefused(ray(Vector3d::Zero(), Vector3d(kNan, 0, 1), 1.0F), "directions[0]");
  expectRefused(ray(Vector3d::Zero(), Vector3d(kInfinity, 0, 1), 1.0F), "directions[0]");
  expectRefused(ray(Vector3d(kInfinity, 0, 0), Vector3d::UnitX(), 1.0F), "origins[0]");
  expectRefused(ray(Vector3d::Zero(), Vector3d::UnitX(), -1.0F), "max_range is -1");
  expectRefused(ray(Vector3d::Zero(), Vector3d::UnitX(), std::numeric_limits<float>::infinity()), "max_range is inf");

  expectRefused(box(Vector3d(0, 0, 1), Vector3d::Zero()), "min must be the lower corner");
  expectRefused(box(Vector3d(kNan, 0, 0), Vector3d::Ones()), "min is (");
}

TEST_F(MapQueriesTest, WhatIsNotOfTheFrameIsNotToldOfIt) {
  const auto response = answered<QueryOccupancy::Response>([](auto& filled) {
    filled.state.push_back(1);
    throw std::runtime_error("the disk is full");
  });
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.message, "the disk is full");
  EXPECT_TRUE(response.state.empty());
  expectRefused(askAt({Vector3d::Zero()}, "nowhere"), "frame_id cannot be brought to the map frame: ");
}

TEST_F(MapQueriesTest, DirectionsOfAnyLengthAreTaken) {
  mapScans(1);
  const Vector3d origin = drive_.pose(0) * Vector3d(3.0, 0.0, 0.0);
  const auto expected = queries_.answer(ray(origin, Vector3d(1, 2, -0.3), 9.0F));
  for (const double scale : {1e-300, 1e-5, 3.0, 1e300}) {
    const auto response = queries_.answer(ray(origin, scale * Vector3d(1, 2, -0.3), 9.0F));
    ASSERT_TRUE(response.success) << response.message;
    EXPECT_EQ(response.result, expected.result);
    EXPECT_NEAR(response.ends[0].x, expected.ends[0].x, 1e-3);
  }
}

TEST_F(MapQueriesTest, ClearedSpaceIsUnknownAndTheRestStays) {
  mapScans(3);
  const Vector3d point = drive_.pose(2) * Vector3d(4.0, 0.0, 0.0);
  ASSERT_NE(queries_.answer(askAt({point})).state[0], int{QueryOccupancy::Response::UNKNOWN});
  const std::size_t atoms = server_.read([](const auto& map) { return map.atoms().size(); });
  const auto cleared = queries_.answer(box(point - Vector3d::Ones(), point + Vector3d::Ones()));
  EXPECT_TRUE(cleared.success);
  EXPECT_GT(cleared.removed, 0U);
  EXPECT_EQ(server_.read([](const auto& map) { return map.atoms().size(); }), atoms - cleared.removed);
  EXPECT_EQ(queries_.answer(askAt({point})).state[0], int{QueryOccupancy::Response::UNKNOWN});
  EXPECT_TRUE(queries_.reset().success);
  EXPECT_EQ(server_.read([](const auto& map) { return map.atoms().size(); }), 0U);
}

// Readers in two threads, as fast as they can, do not starve the merge.
TEST_F(MapQueriesTest, QueriesAndScansDoNotWaitForOneAnotherForLong) {
  std::vector<sensor_msgs::PointCloud2> clouds;
  for (int i = 0; i < 10; ++i) {
    transforms_.setTransform(drive_.transform(i), "test");
    clouds.push_back(drive_.cloud(i));
  }
  std::atomic<bool> stop{false};
  std::atomic<int> answered{0};
  std::atomic<double> slowest{0.0};
  const auto ask = [&] {
    const auto request = askAt(std::vector<Vector3d>(1000, Vector3d(1, 1, 1)));
    while (!stop) {
      const auto start = std::chrono::steady_clock::now();
      if (queries_.answer(request).success) ++answered;
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      slowest = std::max(slowest.load(), seconds);
    }
  };
  std::thread first(ask);
  std::thread second(ask);
  const auto start = std::chrono::steady_clock::now();
  for (const auto& cloud : clouds) EXPECT_FALSE(server_.insert(cloud, transforms_).drop);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  stop = true;
  first.join();
  second.join();
  EXPECT_GT(answered, 20);
  EXPECT_LT(slowest, 0.5);
  EXPECT_LT(seconds, 5.0);
  RecordProperty("milliseconds_a_scan", static_cast<int>(100.0 * seconds));
  RecordProperty("slowest_query_milliseconds", static_cast<int>(1000.0 * slowest));
}

}  // namespace
}  // namespace atom_mapping
