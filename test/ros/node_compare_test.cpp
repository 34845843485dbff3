// atom_mapping_node and octomap_baseline_node on the same clouds, held against the scene's truth and one another.
#include <std_srvs/Trigger.h>
#include <unistd.h>
#include <visualization_msgs/MarkerArray.h>

#include <filesystem>

#include "atom_mapping/CheckCollision.h"
#include "atom_mapping/MapFile.h"
#include "atom_mapping/QueryOccupancy.h"
#include "atom_mapping/baseline/octomap_baseline.h"
#include "atom_mapping/sim/coverage.h"
#include "node_client.h"

namespace atom_mapping {
namespace {

using atom_map::Coverage;
using atom_map::Occupancy;
using Eigen::Vector3d;

constexpr int kScans = 20;
constexpr double kRadius = 0.5;  // m

class NodeCompare : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    client = new NodeClient;
    drive = new SimulatedDrive;
    const auto subscriber = ros::NodeHandle().subscribe<ScanReport>(
        "/octomap_baseline/scan_report", 100,
        [&reports = baseline_reports](const auto& report) { reports.push_back(*report); });
    const bool both_are_there = NodeClient::waitUntil(
        [&] { return subscriber.getNumPublishers() > 0 && ros::service::exists("/octomap_baseline/save_map", false); });
    ASSERT_TRUE(both_are_there && client->waitForNode());
    ASSERT_TRUE(NodeClient::waitUntil([] { return client->subscribers() == 2; }));
    for (int i = 0; i < kScans; ++i) {
      const auto scan = drive->scan(i);
      for (std::size_t k = i % 3; k < scan.returns.size(); k += 3) addRay(scan.returns[k], drive->pose(i));
      client->publish(drive->transform(i));
      client->publish(atom_map::toPointCloud2(scan, drive->header(i, "velodyne")));
      ASSERT_TRUE(client->waitForReports(static_cast<std::size_t>(i) + 1));
    }
    ASSERT_TRUE(NodeClient::waitUntil([] { return baseline_reports.size() >= kScans; }));
  }

  static void TearDownTestSuite() {
    delete drive;
    delete client;
  }

  static void addRay(const atom_map::SimulatedReturn& echo, const atom_map::Pose& pose) {
    if (!atom_map::isInRange(echo.point, atom_map::ScanParameters())) return;
    rays.push_back({pose.translation(), pose * echo.point.cast<double>(),
                    Vector3d(pose.linear() * echo.true_normal.cast<double>()), atom_map::isThin(echo.kind)});
  }

  static double trueDistance(const Vector3d& point) { return drive->scene.signedDistance(point); }

  static QueryOccupancy::Response ask(const std::string& node, const std::vector<Vector3d>& points) {
    QueryOccupancy::Request request;
    for (const Vector3d& point : points) request.points.push_back(toPoint(point));
    auto response = NodeClient::call<QueryOccupancy>("query_occupancy", request, node);
    EXPECT_TRUE(response.success) << response.message;
    return response;
  }

  // As the node answers, in one request.
  static Coverage coverageOf(const std::string& node) {
    std::vector<Vector3d> points;
    const auto collect = [&](const Vector3d& point) {
      points.push_back(point);
      return Occupancy::kUnknown;
    };
    atom_map::measureCoverage(rays, kRadius, collect, trueDistance, 1);
    const auto response = ask(node, points);
    std::size_t next = 0;
    const auto replay = [&](const Vector3d&) { return static_cast<Occupancy>(response.state.at(next++)); };
    const Coverage coverage = atom_map::measureCoverage(rays, kRadius, replay, trueDistance, 1);
    std::printf("%-17s free %.4f, false occupied %.4f, unknown %.4f, surface %.4f\n", node.c_str(),
                coverage.free.value(), coverage.false_occupied.value(), coverage.unknown.value(),
                coverage.surface.value());
    return coverage;
  }

  static inline NodeClient* client = nullptr;
  static inline SimulatedDrive* drive = nullptr;
  static inline std::vector<ScanReport> baseline_reports;
  static inline std::vector<atom_map::ObservedRay> rays;
};

TEST_F(NodeCompare, BothUseTheSameReturnsOfEveryScan) {
  ASSERT_EQ(client->reports.size(), baseline_reports.size());
  for (std::size_t i = 0; i < baseline_reports.size(); ++i) {
    const ScanReport& ours = client->reports[i];
    const ScanReport& theirs = baseline_reports[i];
    EXPECT_EQ(theirs.header.stamp, ours.header.stamp);
    EXPECT_EQ(theirs.points_in, ours.points_in);
    EXPECT_EQ(theirs.dropped_thinned, ours.dropped_thinned);
    EXPECT_EQ(theirs.surface_points, ours.surface_points);
    EXPECT_GT(theirs.seconds_total, 0.0F);
  }
  EXPECT_GT(baseline_reports.back().atoms, 1000U);
  EXPECT_TRUE(client->warnings.empty()) << client->warnings.front();
}

TEST_F(NodeCompare, BothAgreeWithTheSceneAndTheAtomsBetter) {
  const Coverage atoms = coverageOf("atom_mapping");
  const Coverage voxels = coverageOf("octomap_baseline");
  EXPECT_GT(voxels.free.value(), 0.85);
  EXPECT_GT(voxels.surface.value(), 0.8);
  EXPECT_LT(voxels.unknown.value(), 0.01);
  EXPECT_GT(atoms.free.value(), voxels.free.value());
  EXPECT_GT(atoms.surface.value(), voxels.surface.value());
}

TEST_F(NodeCompare, SpheresCollideWithSurfacesAndNotWithTheDrivenPath) {
  CheckCollision::Request request;
  request.unknown_is_free = 1;
  for (int i = 0; i < kScans; ++i) {
    request.centers.push_back(toPoint(drive->pose(i).translation()));
    request.radii.push_back(0.1F);
  }
  for (std::size_t i = 0; i < rays.size(); i += 997) {
    request.centers.push_back(toPoint(rays[i].end));
    request.radii.push_back(1.0F);
  }
  const auto response = NodeClient::call<CheckCollision>("check_collision", request, "octomap_baseline");
  ASSERT_TRUE(response.success) << response.message;
  const auto surface = response.collides.begin() + kScans;
  EXPECT_EQ(std::count(response.collides.begin(), surface, 1), 0);
  EXPECT_GE(std::count(surface, response.collides.end(), 1), (response.collides.end() - surface) * 97 / 100);
}

TEST_F(NodeCompare, TopicsShowTheOccupiedVoxels) {
  const auto stamp = drive->header(kScans - 1, "").stamp;
  const auto array = client->receive<visualization_msgs::MarkerArray>(
      "/octomap_baseline/occupied_cells_vis_array",
      [&](const auto& message) { return message.markers.back().header.stamp == stamp; });
  const auto cloud =
      client->receive<sensor_msgs::PointCloud2>("/octomap_baseline/octomap_point_cloud_centers",
                                                [&](const auto& message) { return message.header.stamp == stamp; });
  EXPECT_EQ(array.markers.back().points.size(), cloud.width);
  EXPECT_GT(cloud.width, 500U);
  EXPECT_EQ(cloud.header.frame_id, "map");
}

// What the node answers, the file holds.
TEST_F(NodeCompare, SavedMapAnswersAsTheNodeDoes) {
  MapFile::Request request;
  request.file = testing::TempDir() + "node_compare_" + std::to_string(getpid()) + ".bt";
  const auto saved = NodeClient::call<MapFile>("save_map", request, "octomap_baseline");
  ASSERT_TRUE(saved.success) << saved.message;
  EXPECT_EQ(saved.atoms, baseline_reports.back().atoms);
  octomap::OcTree file(1.0);
  ASSERT_TRUE(file.readBinary(request.file));
  std::filesystem::remove(request.file);
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < rays.size(); i += 97) points.push_back(rays[i].end);
  const auto response = ask("octomap_baseline", points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const octomap::OcTreeNode* const node = file.search(atom_map::toOctomap(points[i]));
    const int state = node == nullptr ? 0 : file.isNodeOccupied(node) ? 2 : 1;
    EXPECT_EQ(response.state[i], state);
  }
}

TEST_F(NodeCompare, DiagnosticsAndResetOfTheBaseline) {  // the last, since tests run in the order of their lines
  EXPECT_TRUE(client->waitForCount("leaves", static_cast<int>(baseline_reports.back().atoms)));
  EXPECT_TRUE(NodeClient::call<std_srvs::Trigger>("reset", {}, "octomap_baseline").success);
  EXPECT_TRUE(NodeClient::waitUntil([] { return client->count("leaves") == 0; }));
}

}  // namespace
}  // namespace atom_mapping
