#include "atom_mapping/ros/no_returns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "atom_mapping/ros/cloud_conversion.h"
#include "atom_mapping/ros/simulated_messages.h"
#include "atom_mapping/sim/make_scene.h"

namespace atom_mapping {
namespace {

using atom_map::LidarModel;
using atom_map::SimulatedScan;
using Eigen::Vector3f;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kDegree = 3.14159265F / 180.0F;

SimulatedScan simulate(const std::string& scene, const LidarModel& model) {
  return atom_map::simulateScan(atom_map::makeScene(scene), atom_map::makeTrajectory(scene), 1.0, model, 1);
}

float angleBetween(const Vector3f& a, const Vector3f& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Of each inferred direction, the angle to the nearest ray that truly had no echo; radians.
float largestError(const std::vector<Vector3f>& inferred, const SimulatedScan& truth) {
  float largest = 0.0F;
  for (const Vector3f& direction : inferred) {
    float nearest = kInfinity;
    for (const auto& no_return : truth.no_returns)
      nearest = std::min(nearest, (no_return.direction - direction).norm());
    largest = std::max(largest, nearest);
  }
  return largest;
}

std::vector<Vector3f> infer(const SimulatedScan& scan, const LidarModel& model) {
  return toLidarScan(atom_map::toOrganizedPointCloud2(scan, model, std_msgs::Header()), true).no_returns;
}

TEST(NoReturns, AreWhereTheSensorLooked) {
  LidarModel model;
  model.firings = 360;
  model.max_range = 30.0;
  const SimulatedScan scan = simulate("campus", model);
  ASSERT_GT(scan.no_returns.size(), 500U);
  std::map<int, int> returns_of_ring;
  for (const auto& r : scan.returns) ++returns_of_ring[r.ring];
  std::size_t tellable = 0;
  for (const auto& r : scan.no_returns) tellable += returns_of_ring[r.ring] > 0 ? 1 : 0;
  const auto inferred = infer(scan, model);
  EXPECT_EQ(inferred.size(), tellable);
  EXPECT_LT(largestError(inferred, scan), 0.02F * kDegree);
}

TEST(NoReturns, LostEchoesAreFoundAgain) {
  LidarModel model;
  model.firings = 360;
  model.dropout = 0.3;
  const SimulatedScan scan = simulate("hall", model);
  const auto inferred = infer(scan, model);
  EXPECT_EQ(inferred.size(), scan.no_returns.size());
  EXPECT_LT(largestError(inferred, scan), 0.02F * kDegree);
}

// Rings at -2, 0 and 2 degrees, firings of one degree clockwise, all returns at 10 m.
std::vector<Vector3f> makeRings(int columns) {
  std::vector<Vector3f> points;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < columns; ++column) {
      const float elevation = 2.0F * static_cast<float>(row - 1) * kDegree;
      const float azimuth = (170.0F - static_cast<float>(column)) * kDegree;
      points.push_back(10.0F * Vector3f(std::cos(elevation) * std::cos(azimuth),
                                        std::cos(elevation) * std::sin(azimuth), std::sin(elevation)));
    }
  }
  return points;
}

TEST(NoReturns, FiringsWithoutAnyReturnLieBetweenTheirNeighbours) {
  const auto all = makeRings(300);
  auto points = all;
  std::vector<Vector3f> lost;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 100; column < 150; ++column) {
      points[row * 300 + column] = Vector3f::Constant(kInfinity);
      lost.push_back(all[row * 300 + column]);
    }
  }
  const auto inferred = inferNoReturns(points, 300);
  ASSERT_EQ(inferred.size(), lost.size());
  for (std::size_t i = 0; i < lost.size(); ++i) EXPECT_LT(angleBetween(inferred[i], lost[i]), 0.02F * kDegree);
}

TEST(NoReturns, WhatNothingTellsOfIsLeftOut) {
  auto points = makeRings(300);
  for (std::size_t column = 0; column < 300; ++column) points[column] = Vector3f::Constant(kInfinity);  // a whole ring
  for (std::size_t row = 1; row < 3; ++row) points[row * 300] = Vector3f::Constant(kInfinity);  // no firing before it
  EXPECT_TRUE(inferNoReturns(points, 300).empty());
  EXPECT_TRUE(inferNoReturns(std::vector<Vector3f>(12, Vector3f::Constant(kInfinity)), 4).empty());
}

TEST(NoReturns, NanAndMinusInfinityAreNoRays) {
  auto points = makeRings(30);
  points[5] = Vector3f::Constant(std::nanf(""));
  points[6] = Vector3f::Constant(-kInfinity);
  points[7] = Vector3f(kInfinity, std::nanf(""), 0.0F);
  points[8] = Vector3f::Zero();
  EXPECT_TRUE(inferNoReturns(points, 30).empty());
  points[9] = Vector3f::Constant(kInfinity);
  EXPECT_EQ(inferNoReturns(points, 30).size(), 1U);
}

TEST(NoReturns, ACameraHasNoRings) {
  std::vector<Vector3f> points;
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 80; ++column) {
      points.emplace_back(0.02F * static_cast<float>(column - 40), 0.02F * static_cast<float>(row - 30), 1.0F);
    }
  }
  points[1000] = Vector3f::Constant(kInfinity);
  EXPECT_TRUE(inferNoReturns(points, 80).empty());
}

}  // namespace
}  // namespace atom_mapping
