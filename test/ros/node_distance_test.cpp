// Signed distances and surfaces by the node's services: 20 scans of the hall, noise 2 cm, r = 0.25 m.
#include <visualization_msgs/Marker.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "atom_mapping/CastRay.h"
#include "atom_mapping/CheckCollision.h"
#include "atom_mapping/ExtractSurface.h"
#include "atom_mapping/QuerySignedDistance.h"
#include "node_client.h"

namespace atom_mapping {
namespace {

using Eigen::Vector3d;

constexpr int kScans = 20;
constexpr double kRadius = 0.25;  // m
constexpr double kNear = 15.0;    // m

class NodeDistance : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    client = new NodeClient;
    drive = new SimulatedDrive;
    ASSERT_TRUE(client->waitForNode());
    for (int i = 0; i < kScans; ++i) {
      const auto scan = drive->scan(i);
      for (std::size_t k = 0; k < scan.returns.size(); k += 50) {
        const auto& echo = scan.returns[k];
        if (static_cast<double>(echo.point.norm()) > kNear) continue;
        points.push_back(drive->pose(i) * echo.true_point.cast<double>());
        normals.emplace_back(drive->pose(i).linear() * echo.true_normal.cast<double>());
      }
      client->publish(drive->transform(i));
      client->publish(atom_map::toPointCloud2(scan, drive->header(i, "velodyne")));
      ASSERT_TRUE(client->waitForReports(static_cast<std::size_t>(i) + 1));
    }
  }

  static void TearDownTestSuite() {
    delete drive;
    delete client;
  }

  static inline NodeClient* client = nullptr;
  static inline SimulatedDrive* drive = nullptr;
  static inline std::vector<Vector3d> points;   // on true surfaces that the drive's rays met
  static inline std::vector<Vector3d> normals;  // of these
};

TEST_F(NodeDistance, TellsTheDistanceAndItsGradient) {
  QuerySignedDistance::Request request;
  for (std::size_t i = 0; i < points.size(); ++i) request.points.push_back(toPoint(points[i] + kRadius * normals[i]));
  const auto response = NodeClient::call<QuerySignedDistance>("query_signed_distance", request);
  ASSERT_TRUE(response.success) << response.message;
  ASSERT_EQ(response.known.size(), points.size());
  double known = 0.0;
  double squares = 0.0;
  double cosines = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (response.known[i] == 0) continue;
    const auto truth = drive->scene.nearest(toVector(request.points[i]));
    const auto& gradient = response.gradient[i];
    known += 1.0;
    squares += std::pow(response.distance[i] - truth.distance, 2);
    cosines += Vector3d(gradient.x, gradient.y, gradient.z).normalized().dot(truth.normal);
    ASSERT_GE(response.variance[i], 0.0F);
  }
  EXPECT_GE(known, 0.9 * static_cast<double>(points.size()));
  EXPECT_LE(std::sqrt(squares / known), 0.25 * kRadius);
  EXPECT_GE(cosines / known, 0.9);
}

TEST_F(NodeDistance, ExtractsASurfaceThatLiesOnTheTrueOneAndShowsIt) {
  ExtractSurface::Request request;
  request.file = std::filesystem::temp_directory_path() / ("surface_" + std::to_string(::getpid()) + ".ply");
  const auto response = NodeClient::call<ExtractSurface>("extract_surface", request);
  ASSERT_TRUE(response.success) << response.message;
  ASSERT_GT(response.mesh.triangles.size(), 10000U);
  ASSERT_EQ(response.variance.size(), response.mesh.vertices.size());
  double squares = 0.0;
  for (const auto& vertex : response.mesh.vertices) {
    squares += std::pow(drive->scene.signedDistance(toVector(vertex)), 2);
  }
  EXPECT_LE(std::sqrt(squares / static_cast<double>(response.mesh.vertices.size())), 0.25 * kRadius);
  for (const auto& triangle : response.mesh.triangles) {
    for (const std::uint32_t vertex : triangle.vertex_indices) ASSERT_LT(vertex, response.mesh.vertices.size());
  }
  const auto marker = client->receive<visualization_msgs::Marker>("/atom_mapping/surface");
  EXPECT_EQ(marker.points.size(), 3 * response.mesh.triangles.size());
  EXPECT_EQ(marker.header.frame_id, "map");
  std::ifstream file(request.file);
  std::string line;
  bool has_variance = false;
  while (std::getline(file, line) && line != "end_header") has_variance |= line == "property float variance";
  EXPECT_TRUE(has_variance);
  std::filesystem::remove(request.file);
}

TEST_F(NodeDistance, ExtractsWithinABoxAndRefusesWhatItCannotDo) {
  ExtractSurface::Request request;
  request.min = toPoint(points.front() - Vector3d::Constant(2.0));
  request.max = toPoint(points.front() + Vector3d::Constant(2.0));
  const auto part = NodeClient::call<ExtractSurface>("extract_surface", request);
  ASSERT_TRUE(part.success) << part.message;
  ASSERT_FALSE(part.mesh.vertices.empty());
  for (const auto& vertex : part.mesh.vertices) {
    EXPECT_LE((toVector(vertex) - points.front()).cwiseAbs().maxCoeff(), 2.0 + kRadius);
  }
  std::swap(request.min, request.max);
  EXPECT_FALSE(NodeClient::call<ExtractSurface>("extract_surface", request).success);
  std::swap(request.min, request.max);
  request.resolution = -0.1F;
  EXPECT_FALSE(NodeClient::call<ExtractSurface>("extract_surface", request).success);
  request.resolution = 0.0F;
  request.file = "/tmp/surface.obj";
  const auto refused = NodeClient::call<ExtractSurface>("extract_surface", request);
  EXPECT_FALSE(refused.success);
  EXPECT_NE(refused.message.find(".ply"), std::string::npos) << refused.message;
}

TEST_F(NodeDistance, SpheresInSurfacesCollideAndRaysEndAtThem) {
  CheckCollision::Request spheres;
  CastRay::Request rays;
  rays.max_range = 3.0F * static_cast<float>(kRadius);
  for (std::size_t i = 0; i < points.size(); i += 10) {
    spheres.centers.push_back(toPoint(points[i]));
    spheres.radii.push_back(0.5F * static_cast<float>(kRadius));
    rays.origins.push_back(toPoint(points[i] + 1.5 * kRadius * normals[i]));
    geometry_msgs::Vector3 down;
    down.x = -normals[i].x();
    down.y = -normals[i].y();
    down.z = -normals[i].z();
    rays.directions.push_back(down);
  }
  const auto collisions = NodeClient::call<CheckCollision>("check_collision", spheres);
  const auto hits = NodeClient::call<CastRay>("cast_ray", rays);
  ASSERT_TRUE(collisions.success && hits.success) << collisions.message << hits.message;
  const auto colliding = std::count(collisions.collides.begin(), collisions.collides.end(), 1);
  const auto hitting = std::count(hits.result.begin(), hits.result.end(), CastRay::Response::HIT);
  const auto all = static_cast<double>(spheres.centers.size());
  EXPECT_GE(static_cast<double>(colliding), 0.97 * all);
  EXPECT_GE(static_cast<double>(hitting), 0.85 * all);
  std::printf("of %.0f: %.3f collide, %.3f are hit\n", all, static_cast<double>(colliding) / all,
              static_cast<double>(hitting) / all);
}

}  // namespace
}  // namespace atom_mapping
