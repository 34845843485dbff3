#include "atom_mapping/ros/baseline_queries.h"

#include <gtest/gtest.h>

#include <limits>

#include "../test_folder.h"
#include "atom_mapping/ros/pose_conversion.h"
#include "map_file_request.h"
#include "simulated_input.h"

namespace atom_mapping {
namespace {

using Eigen::Vector3d;

QueryOccupancy::Request askAt(const std::vector<Vector3d>& points, const std::string& frame = "") {
  QueryOccupancy::Request request;
  request.frame_id = frame;
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

class BaselineQueriesTest : public FolderTest {
 protected:
  void SetUp() override {
    for (int i = 0; i < 3; ++i) {
      transforms_.setTransform(drive_.transform(i), "test");
      ASSERT_FALSE(server_.insert(drive_.cloud(i), transforms_).drop);
    }
  }

  template <class Request>
  void expectRefused(const Request& request, const std::string& message) {
    const auto response = queries_.answer(request);
    EXPECT_FALSE(response.success);
    EXPECT_NE(response.message.find(message), std::string::npos) << response.message;
  }

  // About every point of a scan, some before it and some behind.
  std::vector<Vector3d> points() const {
    std::vector<Vector3d> points;
    for (const auto& echo : drive_.scan(0).returns) {
      for (const double share : {0.5, 0.98, 1.0, 1.02, 1.2}) points.push_back(echo.point.cast<double>() * share);
    }
    return points;
  }

  SimulatedDrive drive_;
  tf2::BufferCore transforms_;
  BaselineServer server_{BaselineParameters()};
  BaselineQueries queries_{server_, transforms_, ServiceParameters()};
};

TEST_F(BaselineQueriesTest, OccupancyIsWhatLiboctomapSays) {
  std::vector<Vector3d> in_map;
  for (const Vector3d& point : points()) in_map.push_back(drive_.pose(0) * point);
  const auto response = queries_.answer(askAt(in_map));
  ASSERT_TRUE(response.success) << response.message;
  std::array<int, 3> counts{};
  server_.read([&](const atom_map::OctomapBaseline& map) {
    for (std::size_t i = 0; i < in_map.size(); ++i) {
      const octomap::OcTreeNode* const node = map.tree().search(atom_map::toOctomap(in_map[i]));
      const int state = node == nullptr ? 0 : map.tree().isNodeOccupied(node) ? 2 : 1;
      ASSERT_EQ(response.state[i], state);
      ASSERT_FLOAT_EQ(response.probability[i], node == nullptr ? 0.5F : static_cast<float>(node->getOccupancy()));
      ++counts[static_cast<std::size_t>(state)];
    }
  });
  for (const int count : counts) EXPECT_GT(count, 1000);
}

TEST_F(BaselineQueriesTest, PointsMayComeInAnyFrameThatTfKnows) {
  const std::vector<Vector3d> in_sensor = points();
  std::vector<Vector3d> in_map;
  for (const Vector3d& point : in_sensor) in_map.push_back(drive_.pose(2) * point);  // tf's newest
  const auto expected = queries_.answer(askAt(in_map));
  const auto response = queries_.answer(askAt(in_sensor, "/velodyne"));
  ASSERT_TRUE(response.success) << response.message;
  std::size_t equal = 0;  // all but those on a voxel's very border
  for (std::size_t i = 0; i < in_map.size(); ++i) equal += response.state[i] == expected.state[i] ? 1 : 0;
  EXPECT_GE(equal, in_map.size() - 10);
  expectRefused(askAt({Vector3d::Zero()}, "nowhere"), "nowhere");
}

TEST_F(BaselineQueriesTest, SpheresCollideWithSurfacesAndTheUnknown) {
  const Vector3d sensor = drive_.pose(0).translation();
  EXPECT_EQ(queries_.answer(sphere(sensor, 0.1F)).collides[0], 0);
  EXPECT_EQ(queries_.answer(sphere(sensor, 5.0F, true)).collides[0], 1) << "the floor";
  EXPECT_EQ(queries_.answer(sphere(sensor + Vector3d(0, 0, 500), 1.0F)).collides[0], 1);
  EXPECT_EQ(queries_.answer(sphere(sensor + Vector3d(0, 0, 500), 1.0F, true)).collides[0], 0);
}

TEST_F(BaselineQueriesTest, WhatCannotBeServedIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expectRefused(askAt({Vector3d(0, nan, 0)}), "points[0]");
  expectRefused(sphere(Vector3d::Zero(), -1.0F), "radii[0] is -1");
  expectRefused(sphere(Vector3d::Zero(), 13.0F), "at most 12.89");
  EXPECT_TRUE(queries_.answer(sphere(Vector3d::Zero(), 13.0F, true)).success);
  CheckCollision::Request unequal = sphere(Vector3d::Zero(), 1.0F);
  unequal.radii.push_back(1.0F);
  expectRefused(unequal, "equally many");
  const BaselineQueries strict(server_, transforms_, ServiceParameters{3});
  EXPECT_NE(strict.answer(askAt(std::vector<Vector3d>(4))).message.find("permits 3"), std::string::npos);
}

TEST_F(BaselineQueriesTest, MapsAreSavedOrItIsSaidWhyNot) {
  const std::string file = path("map.bt");
  const auto saved = queries_.answer(at(file));
  ASSERT_TRUE(saved.success) << saved.message;
  EXPECT_EQ(saved.atoms, server_.read([](const auto& map) { return map.tree().getNumLeafNodes(); }));
  EXPECT_EQ(saved.message, "saved " + std::to_string(saved.atoms) + " leaves to " + file);
  octomap::OcTree tree(1.0);
  EXPECT_TRUE(tree.readBinary(file));
  EXPECT_GT(tree.size(), 1000U);
  expectRefused(at("map.ply"), ".ot or .bt");
  expectRefused(at("map.ply"), "/map.ply");
  expectRefused(at(""), "file is empty; name one");
  expectRefused(at("/none/map.ot"), "No such file or directory");
}

TEST_F(BaselineQueriesTest, ResetLeavesNothingKnown) {
  EXPECT_TRUE(queries_.reset().success);
  const auto response = queries_.answer(askAt({drive_.pose(0).translation()}));
  EXPECT_EQ(response.state[0], int{QueryOccupancy::Response::UNKNOWN});
  EXPECT_FALSE(server_.insert(drive_.cloud(0), transforms_).drop) << "time begins anew";
}

TEST_F(BaselineQueriesTest, ReportsCountLeavesAndBytes) {
  BaselineServer server{BaselineParameters()};
  const auto report = server.insert(drive_.cloud(0), transforms_).report;
  server.read([&](const atom_map::OctomapBaseline& map) {
    EXPECT_EQ(report.atoms, map.tree().getNumLeafNodes());
    EXPECT_EQ(report.map_bytes, map.bytes());
  });
  EXPECT_EQ(report.points_in, report.dropped_nan + report.dropped_too_near + report.dropped_too_far +
                                  report.dropped_no_return + report.dropped_thinned + report.surface_points);
}

}  // namespace
}  // namespace atom_mapping
