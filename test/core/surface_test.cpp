// The implicit surface: closed where the scene is closed, where the true surface is, the same for any number of threads.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

#include "atom_mapping/map/mapper.h"
#include "atom_mapping/surface/extract_surface.h"
#include "check_mesh.h"
#include "simulated.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

MappingParameters parametersFor(Mode mode, double radius) {
  MappingParameters parameters;
  parameters.mode = mode;
  parameters.radius = radius;
  parameters.scan.min_range = 0.4;  // the closed scenes are a metre wide
  return parameters;
}

SurfaceMesh surfaceOf(const Drive& drive, const MappingParameters& parameters, const SurfaceRequest& request = {}) {
  Mapper mapper(parameters);
  for (std::size_t i = 0; i < drive.scans.size(); ++i) mapper.insertScan(drive.scans[i], drive.poses[i]);
  return mapper.read([&](const AtomMap& map) { return extractSurface(map, parameters, request); });
}

void print(const Drive& drive, double radius, Mode mode, const SurfaceMesh& mesh, const SurfaceError& error) {
  std::printf("%-12s r %.2f %-15s surface error rms %.3f r, 95 %% %.3f r; %zu triangles\n", drive.scene_name.c_str(),
              radius, mode == Mode::kOccupancy ? "occupancy" : "signed_distance", error.rms / radius,
              error.percentile_95 / radius, mesh.triangles.size());
}

class ClosedScene : public testing::TestWithParam<std::tuple<const char*, Mode>> {};

TEST_P(ClosedScene, HasAClosedSurfaceThatLooksInwards) {
  const auto [scene, mode] = GetParam();
  const Drive drive = makeDrive(scene, 40);
  const SurfaceMesh mesh = surfaceOf(drive, parametersFor(mode, 0.1));
  const Topology topology = topologyOf(mesh);
  EXPECT_EQ(topology.open_edges, 0U);
  EXPECT_TRUE(topology.manifold);
  EXPECT_EQ(topology.euler, 2);
  const SurfaceError error = errorOf(mesh, drive.scene);
  print(drive, 0.1, mode, mesh, error);
  EXPECT_GE(error.facing_free, 0.995);
  const bool distances = mode == Mode::kSignedDistance;
  EXPECT_LE(error.rms, (distances ? 0.2 : 0.3) * 0.1);
  const bool is_oblique = drive.scene_name == "cube_rotated";  // its edges are what both modes round most
  EXPECT_LE(error.percentile_95, (!distances ? 0.65 : is_oblique ? 0.55 : 0.5) * 0.1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ClosedScene,
                         testing::Combine(testing::Values("cube", "cube_rotated", "sphere"),
                                          testing::Values(Mode::kOccupancy, Mode::kSignedDistance)));

TEST(Surface, OfTheHallReachesItsFigures) {
  const Drive hall = makeDrive("hall", 40);
  SurfaceRequest request;
  request.threads = 2;
  const SurfaceMesh mesh = surfaceOf(hall, parametersFor(Mode::kSignedDistance, 0.25), request);
  const SurfaceError error = errorOf(mesh, hall.scene);
  print(hall, 0.25, Mode::kSignedDistance, mesh, error);
  EXPECT_LE(error.rms, 0.2 * 0.25);
  EXPECT_LE(error.percentile_95, 0.5 * 0.25);
  EXPECT_GT(mesh.triangles.size(), 30000U);
}

class SphereSurface : public testing::Test {
 protected:
  static constexpr double kRadius = 0.1;

  SurfaceMesh extract(const SurfaceRequest& request) {
    return mapper_.read([&](const AtomMap& map) { return extractSurface(map, parameters_, request); });
  }

  void SetUp() override {
    const Drive drive = makeDrive("sphere", 20);
    for (std::size_t i = 0; i < drive.scans.size(); ++i) mapper_.insertScan(drive.scans[i], drive.poses[i]);
  }

  MappingParameters parameters_ = parametersFor(Mode::kSignedDistance, kRadius);
  Mapper mapper_{parameters_};
};

TEST_F(SphereSurface, IsTheSameForAnyNumberOfThreads) {
  SurfaceRequest request;
  const SurfaceMesh one = extract(request);
  request.threads = 4;
  const SurfaceMesh four = extract(request);
  EXPECT_EQ(one.vertices, four.vertices);
  EXPECT_EQ(one.triangles, four.triangles);
  EXPECT_EQ(one.variance, four.variance);
}

TEST_F(SphereSurface, InABoxIsTheWholeOnesPartWithinACell) {
  SurfaceRequest request;
  request.box = {Vector3d(0.0, -2.0, -2.0), Vector3d(2.0, 2.0, 2.0)};
  const SurfaceMesh half = extract(request);
  const SurfaceMesh whole = extract({});
  const auto inside = static_cast<std::size_t>(std::count_if(
      whole.vertices.begin(), whole.vertices.end(), [&](const auto& v) { return v.x() + whole.origin.x() > kRadius; }));
  EXPECT_GE(half.vertices.size(), inside);
  EXPECT_LT(half.vertices.size(), whole.vertices.size() * 6 / 10);
  for (const auto& vertex : half.vertices) EXPECT_GE(vertex.x() + half.origin.x(), -kRadius);
}

TEST_F(SphereSurface, RefusesWhatItCannotDo) {
  SurfaceRequest request;
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float resolution : {-1.0F, std::nanf(""), infinity, -infinity, 1e-4F * 0.99F, 1e-9F, 1e-45F}) {
    request.resolution = resolution;
    EXPECT_THROW(extract(request), std::invalid_argument) << resolution;
  }
  request.resolution = 0.0F;
  request.max_cells = 10;
  EXPECT_THROW(extract(request), std::invalid_argument);
}

// The ways between atoms alone would be 100 million cells here.
TEST_F(SphereSurface, RefusesTooManyCellsBeforeTheyFillTheMemory) {
  SurfaceRequest request;
  request.resolution = 1.01e-4F;
  request.max_cells = 10000;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(extract(request), std::invalid_argument);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

TEST_F(SphereSurface, OfAnEmptyMapIsEmpty) {
  mapper_.reset();
  EXPECT_TRUE(extract({}).triangles.empty());
}

}  // namespace
}  // namespace atom_map
