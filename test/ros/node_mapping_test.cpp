// The figures of issue 2 through the node: 40 scans of the hall at 10 Hz, noise 2 cm, r = 0.5 m, range 25 m.
#include <std_srvs/Trigger.h>
#include <visualization_msgs/Marker.h>

#include <atomic>
#include <thread>

#include "atom_mapping/CastRay.h"
#include "atom_mapping/CheckCollision.h"
#include "atom_mapping/ClearRegion.h"
#include "atom_mapping/QueryOccupancy.h"
#include "atom_mapping/sim/coverage.h"
#include "node_client.h"

namespace atom_mapping {
namespace {

using atom_map::Occupancy;
using Eigen::Vector3d;
using visualization_msgs::Marker;

constexpr int kScans = 40;
constexpr double kRadius = 0.5;     // m
constexpr double kMaxRange = 25.0;  // m
constexpr std::size_t kBatch = 100000;

std::vector<Occupancy> askNode(const std::vector<Vector3d>& points) {
  std::vector<Occupancy> answers;
  for (std::size_t begin = 0; begin < points.size(); begin += kBatch) {
    QueryOccupancy::Request request;
    for (std::size_t i = begin; i < std::min(begin + kBatch, points.size()); ++i) {
      request.points.push_back(toPoint(points[i]));
    }
    const auto response = NodeClient::call<QueryOccupancy>("query_occupancy", request);
    EXPECT_TRUE(response.success) << response.message;
    for (const std::uint8_t state : response.state) answers.push_back(static_cast<Occupancy>(state));
  }
  return answers;
}

// Asks the node as often as it can while scans are merged.
class Questioner {
 public:
  ~Questioner() {
    stop_ = true;
    thread_.join();
  }

  std::atomic<int> answered{0};
  std::atomic<double> slowest{0.0};  // s

 private:
  void ask() {
    QueryOccupancy::Request request;
    for (int i = 0; i < 1000; ++i) request.points.push_back(toPoint(Vector3d(0.02 * i, 0.0, 1.0)));
    while (!stop_) {
      const ros::WallTime start = ros::WallTime::now();
      if (NodeClient::call<QueryOccupancy>("query_occupancy", request).success) ++answered;
      slowest = std::max(slowest.load(), (ros::WallTime::now() - start).toSec());
    }
  }

  std::atomic<bool> stop_{false};
  std::thread thread_{[this] { ask(); }};
};

class NodeMapping : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    client = new NodeClient;
    drive = new SimulatedDrive;
    std::vector<sensor_msgs::PointCloud2> clouds;
    for (int i = 0; i < kScans; ++i) {
      const auto scan = drive->scan(i);
      clouds.push_back(atom_map::toPointCloud2(scan, drive->header(i, "velodyne")));
      addRays(scan, drive->pose(i));
    }
    ASSERT_TRUE(client->waitForNode());
    const Questioner questioner;
    ros::WallRate rate(10.0);
    for (int i = 0; i < kScans; ++i) {
      client->publish(drive->transform(i));
      client->publish(clouds[static_cast<std::size_t>(i)]);
      rate.sleep();
    }
    ASSERT_TRUE(client->waitForReports(kScans));
    answered = questioner.answered;
    slowest = questioner.slowest;
  }

  static void TearDownTestSuite() {
    delete drive;
    delete client;
  }

  static void addRays(const atom_map::SimulatedScan& scan, const atom_map::Pose& pose) {
    for (const auto& echo : scan.returns) {
      if (static_cast<double>(echo.point.norm()) > kMaxRange) continue;
      rays.push_back({pose.translation(), pose * echo.point.cast<double>(),
                      Vector3d(pose.linear() * echo.true_normal.cast<double>()), atom_map::isThin(echo.kind)});
    }
  }

  static inline NodeClient* client = nullptr;
  static inline SimulatedDrive* drive = nullptr;
  static inline std::vector<atom_map::ObservedRay> rays;
  static inline int answered = 0;
  static inline double slowest = 0.0;
};

TEST_F(NodeMapping, LosesNoScan) {
  ASSERT_EQ(client->reports.size(), static_cast<std::size_t>(kScans));
  for (int i = 0; i < kScans; ++i) EXPECT_EQ(client->reports[i].header.stamp, drive->header(i, "").stamp);
  ASSERT_TRUE(client->waitForCount("mapped", kScans));
  for (const auto& [key, value] : client->diagnostics) {
    EXPECT_TRUE(key.find("dropped") != 0 || value == "0") << key << " " << value;
  }
  EXPECT_EQ(client->count("atoms"), static_cast<int>(client->reports.back().atoms));
  EXPECT_TRUE(client->warnings.empty()) << client->warnings.front();
}

TEST_F(NodeMapping, AnswersWhileScansAreMerged) {
  EXPECT_GT(answered, 40);
  EXPECT_LT(slowest, 0.5);
  RecordProperty("answers", answered);
  RecordProperty("slowest_milliseconds", static_cast<int>(1000.0 * slowest));
}

TEST_F(NodeMapping, AgreesWithTheSceneAsWellAsItMust) {
  std::vector<Vector3d> points;
  const auto collect = [&](const Vector3d& point) {
    points.push_back(point);
    return Occupancy::kUnknown;
  };
  const auto truth = [](const Vector3d& point) { return drive->scene.signedDistance(point); };
  atom_map::measureCoverage(rays, kRadius, collect, truth, 1);
  const std::vector<Occupancy> answers = askNode(points);
  std::size_t next = 0;
  const auto replay = [&](const Vector3d& point) {
    EXPECT_EQ(point, points[next]);
    return answers[next++];
  };
  const auto coverage = atom_map::measureCoverage(rays, kRadius, replay, truth, 1);
  std::printf("free %.4f, false occupied %.4f, unknown %.4f, surface %.4f, thin %.4f\n", coverage.free.value(),
              coverage.false_occupied.value(), coverage.unknown.value(), coverage.surface.value(),
              coverage.thin.value());
  EXPECT_GE(coverage.free.value(), 0.97);
  EXPECT_LE(coverage.false_occupied.value(), 0.015);
  EXPECT_GE(coverage.surface.value(), 0.97);
  EXPECT_GE(coverage.thin.value(), 0.97);
  EXPECT_GT(coverage.thin.whole, 1000U);
}

TEST_F(NodeMapping, RaysEndAtTheSurfaces) {
  CastRay::Request request;
  request.max_range = static_cast<float>(kMaxRange);
  for (std::size_t i = 0; i < rays.size(); i += 997) {
    const Vector3d along = (rays[i].end - rays[i].sensor).normalized();
    request.origins.push_back(toPoint(rays[i].sensor + 2.0 * along));  // beyond the blind spot
    request.directions.emplace_back();
    request.directions.back().x = along.x();
    request.directions.back().y = along.y();
    request.directions.back().z = along.z();
  }
  const auto response = NodeClient::call<CastRay>("cast_ray", request);
  ASSERT_TRUE(response.success) << response.message;
  atom_map::Share hits;
  atom_map::Share near_surface;  // of the hits
  for (std::size_t i = 0; i < request.origins.size(); ++i) {
    hits.count(response.result[i] == CastRay::Response::HIT);
    if (response.result[i] != CastRay::Response::HIT) continue;
    const double distance = drive->scene.signedDistance(toVector(response.ends[i]));
    near_surface.count(distance < 2.0 * kRadius);
    EXPECT_GT(distance, -kRadius);
  }
  std::printf("rays: %.4f hit, %.4f of them within 2r of a surface\n", hits.value(), near_surface.value());
  EXPECT_GT(hits.whole, 500U);
  EXPECT_GE(hits.value(), 0.9);
  EXPECT_GE(near_surface.value(), 0.98);
}

TEST_F(NodeMapping, SpheresCollideWithSurfacesAndNotWithTheDrivenPath) {
  CheckCollision::Request path;
  path.unknown_is_free = 1;
  for (int i = 0; i < kScans; ++i) {
    path.centers.push_back(toPoint(drive->pose(i).translation()));
    path.radii.push_back(0.1F);
  }
  const auto on_path = NodeClient::call<CheckCollision>("check_collision", path);
  ASSERT_TRUE(on_path.success) << on_path.message;
  for (const std::uint8_t collides : on_path.collides) EXPECT_EQ(collides, 0);

  CheckCollision::Request surface;
  surface.unknown_is_free = 1;
  for (std::size_t i = 0; i < rays.size(); i += 97) {
    surface.centers.push_back(toPoint(rays[i].end));
    surface.radii.push_back(0.3F);  // less than an atom's
  }
  const auto at_surface = NodeClient::call<CheckCollision>("check_collision", surface);
  ASSERT_TRUE(at_surface.success) << at_surface.message;
  std::size_t collisions = 0;
  for (const std::uint8_t collides : at_surface.collides) collisions += collides;
  EXPECT_GE(collisions, surface.centers.size() * 97 / 100);
}

TEST_F(NodeMapping, TopicsShowTheWholeMap) {
  const std::size_t atoms = client->reports.back().atoms;
  const auto occupied = client->receive<Marker>("/atom_mapping/atoms");
  const auto free = client->receive<Marker>("/atom_mapping/free_atoms");
  const auto cloud = client->receive<sensor_msgs::PointCloud2>("/atom_mapping/atom_cloud");
  EXPECT_EQ(occupied.points.size() + free.points.size(), atoms);
  EXPECT_GT(occupied.points.size(), atoms / 10);
  EXPECT_EQ(occupied.scale.x, 2.0 * kRadius);
  EXPECT_EQ(occupied.header.frame_id, "map");
  EXPECT_EQ(cloud.width, atoms);
  EXPECT_EQ(cloud.header.stamp, drive->header(kScans - 1, "").stamp);
}

TEST_F(NodeMapping, ClearingAndResetEmptyTheMap) {  // the last, since tests run in the order of their lines
  ClearRegion::Request box;
  const Vector3d sensor = drive->pose(0).translation();
  box.min = toPoint(sensor - Vector3d::Constant(5.0));
  box.max = toPoint(sensor + Vector3d::Constant(5.0));
  const auto cleared = NodeClient::call<ClearRegion>("clear_region", box);
  EXPECT_TRUE(cleared.success);
  EXPECT_GT(cleared.removed, 100U);
  const int left = static_cast<int>(client->reports.back().atoms - cleared.removed);
  EXPECT_TRUE(NodeClient::waitUntil([&] { return client->count("atoms") == left; }));
  EXPECT_TRUE(NodeClient::call<std_srvs::Trigger>("reset", {}).success);
  EXPECT_TRUE(NodeClient::waitUntil([] { return client->count("atoms") == 0; }));
  client->receive<Marker>("/atom_mapping/atoms", [](const Marker& marker) { return marker.action == Marker::DELETE; });
}

}  // namespace
}  // namespace atom_mapping
