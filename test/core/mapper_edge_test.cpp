// The mapper with scans and parameters at the edge of what there is.
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "atom_mapping/map/mapper.h"
#include "atom_mapping/query/occupancy.h"
#include "check_map.h"
#include "draw.h"
#include "simulated.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

// A sixth of a VLP-16's firings in a room with walls 4 m away.
LidarScan scanRoom() {
  LidarModel model;
  model.firings = 300;
  return toLidarScan(scanFromOrigin({makeRoom(4.0)}, model));
}

MappingParameters makeParameters() {
  MappingParameters parameters;
  parameters.scan.horizontal_resolution = 1.2;
  return parameters;
}

std::vector<float> bytesOf(const Mapper& mapper) {
  return mapper.read([](const AtomMap& map) { return bytesOf(map); });
}

Occupancy ask(const Mapper& mapper, const Vector3d& point) {
  return mapper.read([&](const AtomMap& map) { return classify(interpolate(map, map.toLocal(point))); });
}

TEST(MapperEdge, ScansWithoutAnyReturnChangeNothing) {
  Mapper mapper(makeParameters());
  for (const LidarScan& scan : {LidarScan{}, LidarScan{std::vector<Vector3f>(500, {kNan, kNan, kNan}), {}},
                                LidarScan{std::vector<Vector3f>(500, {kInf, kInf, kInf}), {}},
                                LidarScan{std::vector<Vector3f>(500, {-kInf, -kInf, -kInf}), {}},
                                LidarScan{std::vector<Vector3f>(500, {1e4F, 0.0F, 0.0F}), {}}}) {
    const ScanReport report = mapper.insertScan(scan, Pose::Identity());
    EXPECT_EQ(report.filter.points_in, scan.points.size());
    EXPECT_EQ(report.surface_points + report.candidates_proposed + report.candidates_kept + report.atoms, 0U);
  }
  mapper.insertScan(scanRoom(), Pose::Identity());
  const std::vector<float> before = bytesOf(mapper);
  EXPECT_FALSE(before.empty());
  mapper.insertScan(LidarScan{}, Pose::Identity());
  EXPECT_EQ(bytesOf(mapper), before);
}

TEST(MapperEdge, BadPointsAmongGoodOnesChangeNothing) {
  const LidarScan good = scanRoom();
  LidarScan mixed = good;
  for (const float bad : {kNan, kInf, -kInf, 3e38F}) mixed.points.insert(mixed.points.end(), 50, {bad, 1.0F, bad});
  Mapper mapper(makeParameters());
  Mapper with_bad_points(makeParameters());
  mapper.insertScan(good, Pose::Identity());
  const ScanReport report = with_bad_points.insertScan(mixed, Pose::Identity());
  EXPECT_EQ(report.filter.nan + report.filter.no_return + report.filter.too_near + report.filter.too_far, 200U);
  EXPECT_EQ(bytesOf(mapper), bytesOf(with_bad_points));
}

TEST(MapperEdge, AnyScanLeavesASoundMap) {
  Random random(1);
  for (int i = 0; i < 40; ++i) {
    MappingParameters parameters = makeParameters();
    parameters.radius = static_cast<double>(draw(random, 0.1F, 3.0F));
    parameters.rays.candidate_cell = i % 3 == 0 ? 0.0 : 1.0;
    parameters.occupancy.hit_probability = 0.99;
    parameters.scan.clear_no_returns = i % 2 == 0;
    Mapper mapper(parameters);
    for (int k = 0; k < 3; ++k) {
      LidarScan scan;
      for (int n = 0; n < 300; ++n) scan.points.emplace_back(draw(random, 0.0F, 30.0F) * drawDirection(random));
      for (int n = 0; n < 50; ++n) scan.no_returns.push_back(drawDirection(random));
      mapper.insertScan(scan, drawPose(random, 20.0));
      mapper.read([&](const AtomMap& map) {
        expectNoOverlap(map);
        expectWithinClamps(map, parameters.occupancy.max_log_odds);
      });
    }
  }
}

TEST(MapperEdge, RaysWithoutReturnFreeTheirSpaceOnlyIfAskedTo) {
  const LidarScan scan{{}, {Vector3f::UnitX(), Vector3f::UnitY()}};
  for (const bool clear : {false, true}) {
    MappingParameters parameters = makeParameters();
    parameters.scan.clear_no_returns = clear;
    parameters.rays.lambda = 1e6;
    Mapper mapper(parameters);
    const Pose pose = Eigen::Translation3d(7.0, 8.0, 9.0) * Eigen::AngleAxisd(0.5 * M_PI, Vector3d::UnitZ());
    mapper.insertScan(scan, pose);
    for (const double range : {1.0, 10.0, 24.0}) {
      for (const Vector3d& direction : {Vector3d(0, 1, 0), Vector3d(-1, 0, 0)}) {  // x and y, turned
        EXPECT_EQ(ask(mapper, pose.translation() + range * direction), clear ? Occupancy::kFree : Occupancy::kUnknown);
      }
    }
    EXPECT_EQ(ask(mapper, pose.translation() + Vector3d(0, 26, 0)), Occupancy::kUnknown);
  }
}

TEST(MapperEdge, ClearedRegionsAreUnknownAndCanBeMappedAgain) {
  Mapper mapper(makeParameters());
  const Pose pose(Eigen::Translation3d(1e5, 0.0, 0.0));
  mapper.insertScan(scanRoom(), pose);
  const Vector3d free(1e5 + 2.0, 0.0, 0.0);
  EXPECT_EQ(ask(mapper, free), Occupancy::kFree);
  const Eigen::AlignedBox3d box(Vector3d(1e5, -3.0, -3.0), Vector3d(1e5 + 3.0, 3.0, 3.0));
  EXPECT_GT(mapper.write([&](AtomMap& map) { return map.clearRegion(box); }), 0U);
  EXPECT_EQ(ask(mapper, free), Occupancy::kUnknown);
  EXPECT_EQ(ask(mapper, {1e5 - 2.0, 0.0, 0.0}), Occupancy::kFree);
  mapper.insertScan(scanRoom(), pose);
  EXPECT_EQ(ask(mapper, free), Occupancy::kFree);
}

std::size_t atomsOfTheRoom(const Mapper& mapper) {
  std::size_t count = 0;
  mapper.read([&](const AtomMap& map) {
    map.atoms().forEachInBox({Vector3f::Constant(-10.0F), Vector3f::Constant(10.0F)}, [&](ConstAtomRef) { ++count; });
  });
  return count;
}

// As a wrong transform has it. Floats tell places there apart by some decimetres only: the map is of no use, but sound.
TEST(MapperEdge, BearsASensorThatJumpsToTheEndOfTheWorld) {
  for (const double radius : {0.05, 0.25}) {
    for (const Mode mode : {Mode::kOccupancy, Mode::kSignedDistance}) {
      MappingParameters parameters = makeParameters();
      parameters.radius = radius;
      parameters.mode = mode;
      parameters.scan.clear_no_returns = true;
      Mapper mapper(parameters);
      mapper.insertScan(scanRoom(), Pose::Identity());
      const std::size_t before = atomsOfTheRoom(mapper);
      EXPECT_GT(before, 100U);
      for (const double jump : {1e5, 5e6, 9e6, 9e7}) {
        Pose pose = Pose::Identity();
        pose.translation() = Vector3d(jump, -0.3 * jump, 2.0);
        mapper.insertScan(scanRoom(), pose);
      }
      EXPECT_EQ(atomsOfTheRoom(mapper), before);
    }
  }
}

TEST(MapperEdge, EveryParameterOutOfItsRangeIsNamedAtOnce) {
  MappingParameters parameters;
  parameters.radius = -1.0;
  parameters.occupancy.hit_probability = 1.5;
  parameters.scan.min_range = 30.0;
  try {
    const Mapper mapper(parameters);
    FAIL() << "no throw";
  } catch (const std::invalid_argument& error) {
    for (const char* name : {"radius", "occupancy/hit_probability", "scan/min_range"}) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << name;
    }
  }
}

}  // namespace
}  // namespace atom_map
