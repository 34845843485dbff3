#include <std_srvs/Trigger.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "atom_mapping/CastRay.h"
#include "atom_mapping/CheckCollision.h"
#include "atom_mapping/ClearRegion.h"
#include "atom_mapping/QueryOccupancy.h"
#include "atom_mapping/ros/map_messages.h"
#include "node_client.h"

namespace atom_mapping {
namespace {

using Eigen::Vector3d;

// The tests build on one another, in the order of their lines.
class NodeHostile : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    client = new NodeClient;
    drive = new SimulatedDrive(makeCoarseDrive());
    witness = new ScanServer{atom_map::MappingParameters()};
    ASSERT_TRUE(client->waitForNode());
  }

  static void TearDownTestSuite() {
    delete witness;
    delete drive;
    delete client;
  }

  // Maps a good scan in the node and in a server of the test's own.
  static void mapScan(int i) {
    const std::size_t before = client->reports.size();
    transforms.setTransform(drive->transform(i), "test");
    ASSERT_FALSE(witness->insert(drive->cloud(i), transforms).drop);
    client->publish(drive->transform(i));
    client->publish(drive->cloud(i));
    ASSERT_TRUE(client->waitForReports(before + 1));
  }

  // Byte for byte, as whoever asks sees it.
  static void expectMapOfGoodScansOnly() {
    const auto expected = toAtomCloud(takeSnapshot(*witness));
    const auto cloud = client->receive<sensor_msgs::PointCloud2>(
        "/atom_mapping/atom_cloud", [&](const auto& message) { return message.header.stamp == expected.header.stamp; });
    EXPECT_GT(cloud.width, 100U);
    EXPECT_EQ(cloud.data, expected.data);
  }

  static inline NodeClient* client = nullptr;
  static inline SimulatedDrive* drive = nullptr;
  static inline ScanServer* witness = nullptr;  // sees the good scans only
  static inline tf2::BufferCore transforms;
};

TEST_F(NodeHostile, EverythingIsAnsweredBeforeTheFirstScan) {
  QueryOccupancy::Request occupancy;
  occupancy.points.resize(3);
  const auto states = NodeClient::call<QueryOccupancy>("query_occupancy", occupancy);
  EXPECT_TRUE(states.success);
  EXPECT_EQ(states.state, (std::vector<std::uint8_t>{0, 0, 0}));
  CheckCollision::Request spheres;
  spheres.centers.resize(1);
  spheres.radii.resize(1);
  const auto collides = NodeClient::call<CheckCollision>("check_collision", spheres);
  EXPECT_TRUE(collides.success);
  EXPECT_EQ(collides.collides, (std::vector<std::uint8_t>{1}));
  CastRay::Request rays;
  rays.origins.resize(1);
  rays.directions.resize(1);
  rays.directions[0].x = 1.0;
  rays.max_range = 10.0F;
  const auto cast = NodeClient::call<CastRay>("cast_ray", rays);
  EXPECT_TRUE(cast.success);
  EXPECT_EQ(cast.result, (std::vector<std::uint8_t>{CastRay::Response::UNKNOWN}));
  const auto cleared = NodeClient::call<ClearRegion>("clear_region", ClearRegion::Request());
  EXPECT_TRUE(cleared.success);
  EXPECT_EQ(cleared.removed, 0U);
  EXPECT_TRUE(NodeClient::call<std_srvs::Trigger>("reset", {}).success);
}

TEST_F(NodeHostile, MalformedCloudsAreRefusedAndCounted) {
  mapScan(0);
  client->publish(drive->transform(1));
  const auto faults = malformations();
  for (const Fault& fault : faults) {
    auto cloud = drive->cloud(1);
    fault.spoil(cloud);
    client->publish(cloud);
  }
  EXPECT_TRUE(client->waitForCount("dropped: malformed", static_cast<int>(faults.size())));
  EXPECT_EQ(client->reports.size(), 1U);
  client->expectOneWarning("malformed cloud");  // one line, the others are throttled
  expectMapOfGoodScansOnly();
}

TEST_F(NodeHostile, UnknownFramesAreGivenUpInTime) {
  auto cloud = drive->cloud(1);
  cloud.header.frame_id = "nowhere";
  client->publish(cloud);
  client->publish(cloud);
  EXPECT_TRUE(client->waitForCount("dropped: no transform", 2));
  EXPECT_NE(client->diagnostics["last drop"].find("nowhere"), std::string::npos) << client->diagnostics["last drop"];
  client->expectOneWarning("no transform in time from nowhere to map");
}

TEST_F(NodeHostile, ACloudWaitsForItsTransform) {
  const std::size_t before = client->reports.size();
  client->publish(drive->cloud(2));
  ros::WallDuration(0.1).sleep();  // less than the node's timeout
  client->publish(drive->transform(2));
  EXPECT_TRUE(client->waitForReports(before + 1));
  transforms.setTransform(drive->transform(2), "test");
  witness->insert(drive->cloud(2), transforms);
}

TEST_F(NodeHostile, StampsThatJumpBackAreRefusedAndCounted) {
  mapScan(5);
  for (const int i : {0, 2, 1}) client->publish(drive->cloud(i));
  EXPECT_TRUE(client->waitForCount("dropped: out of order", 3));
  client->expectOneWarning("out of order");
  expectMapOfGoodScansOnly();
}

TEST_F(NodeHostile, FarFutureStampsAreGivenUp) {
  auto cloud = drive->cloud(6);
  cloud.header.stamp = ros::Time(4000000000U, 0);
  client->publish(cloud);
  EXPECT_TRUE(client->waitForCount("dropped: no transform", 3));
  mapScan(6);
  expectMapOfGoodScansOnly();
}

TEST_F(NodeHostile, PointsThatAreNotFiniteAreCountedAndEmptyCloudsMapped) {
  auto cloud = drive->cloud(7);
  const float inf = std::numeric_limits<float>::infinity();
  const std::array<float, 4> bad{std::nanf(""), inf, -inf, 1e30F};
  for (std::size_t i = 0; i < 4; ++i) std::memcpy(&cloud.data[i * cloud.point_step], &bad[i], 4);
  const std::size_t before = client->reports.size();
  client->publish(drive->transform(7));
  client->publish(cloud);
  ASSERT_TRUE(client->waitForReports(before + 1));
  EXPECT_EQ(client->reports.back().dropped_nan, 1U);
  EXPECT_EQ(client->reports.back().dropped_no_return, 1U);
  EXPECT_GE(client->reports.back().dropped_too_near, 1U);
  sensor_msgs::PointCloud2 empty;
  empty.header = drive->header(8, "velodyne");
  client->publish(drive->transform(8));
  client->publish(empty);
  ASSERT_TRUE(client->waitForReports(before + 2));
  EXPECT_EQ(client->reports.back().points_in, 0U);
  EXPECT_TRUE(client->waitForCount("mapped: empty", 1));
}

TEST_F(NodeHostile, FaultyRequestsAreRefusedAndTheNodeLivesOn) {
  QueryOccupancy::Request request;
  request.points.resize(1);
  request.points[0].y = std::nan("");
  EXPECT_FALSE(NodeClient::call<QueryOccupancy>("query_occupancy", request).success);
  request.points[0].y = 0.0;
  request.frame_id = "nowhere";
  const auto response = NodeClient::call<QueryOccupancy>("query_occupancy", request);
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("nowhere"), std::string::npos);
  request.frame_id = "velodyne";
  EXPECT_TRUE(NodeClient::call<QueryOccupancy>("query_occupancy", request).success);
}

// A bag that is played again without a clock: the stamps go back, and the sensor stands elsewhere.
TEST_F(NodeHostile, StampsThatGoOnInThePastAreANewBeginning) {
  mapScan(1000);
  const std::size_t before = client->reports.size();
  int i = 0;
  EXPECT_TRUE(NodeClient::waitUntil([&] {
    if (i < 20) {
      client->publish(drive->transform(i));
      client->publish(drive->cloud(i));
      ++i;
    }
    return client->reports.size() > before;
  }));
  EXPECT_LT(client->reports.back().header.stamp, drive->header(20, "").stamp);
  client->expectOneWarning("Time began anew");
}

}  // namespace
}  // namespace atom_mapping
