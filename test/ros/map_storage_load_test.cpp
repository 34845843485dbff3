// A map that was saved and is loaded is the same map, in the file's mode and radius, and mapping goes on from it.
#include <algorithm>
#include <cmath>

#include "atom_mapping/io/map_file.h"
#include "atom_mapping/ros/map_queries.h"
#include "atom_mapping/ros/map_snapshot.h"
#include "map_storage_folder.h"

namespace atom_mapping {
namespace {

using atom_map::AtomMap;

TEST_F(MapStorageTest, SavedResetAndLoadedIsTheSameMap) {
  MapStorage storage(server_, {});
  mapScans(server_, 0, 3);
  const std::vector<float> before = bitsOf(server_);
  const auto saved = storage.save(at(path("map.h5")));
  ASSERT_TRUE(saved.success) << saved.message;
  EXPECT_EQ(saved.atoms, server_.read([](const AtomMap& map) { return map.atoms().size(); }));
  EXPECT_GT(saved.atoms, 100U);
  const std::string atoms = std::to_string(saved.atoms) + " atoms ";
  EXPECT_EQ(saved.message, "saved " + atoms + "to " + path("map.h5"));
  server_.reset();
  const std::uint64_t revision = server_.revision();
  const auto loaded = storage.load(at(path("map.h5")));
  ASSERT_TRUE(loaded.success) << loaded.message;
  EXPECT_EQ(loaded.atoms, saved.atoms);
  EXPECT_EQ(loaded.message, "loaded " + atoms + "from " + path("map.h5"));
  EXPECT_EQ(bitsOf(server_), before);
  EXPECT_GT(server_.revision(), revision);
}

TEST_F(MapStorageTest, MappingGoesOnFromALoadedMapEvenWithOlderClouds) {
  mapScans(server_, 0, 4);
  ScanServer first(coarse());
  mapScans(first, 0, 2);
  ASSERT_TRUE(MapStorage(first, {}).save(at(path("map.h5"))).success);
  ScanServer second(coarse());
  mapScans(second, 3, 4);
  ASSERT_TRUE(MapStorage(second, {}).load(at(path("map.h5"))).success);
  mapScans(second, 2, 4);
  EXPECT_EQ(bitsOf(second), bitsOf(server_));
}

// Of points around where the sensor was.
QuerySignedDistance::Response distancesIn(ScanServer& server, const Eigen::Vector3d& sensor) {
  QuerySignedDistance::Request request;
  for (int i = 0; i < 2000; ++i) {
    geometry_msgs::Point point;
    point.x = sensor.x() + 0.005 * i * std::cos(i);
    point.y = sensor.y() + 0.005 * i * std::sin(i);
    point.z = sensor.z() - 1.0 + 0.001 * i;
    request.points.push_back(point);
  }
  const tf2::BufferCore transforms;
  return MapQueries(server, transforms, {}).answer(request);
}

TEST_F(MapStorageTest, AnEmptyMapTakesOverModeAndRadiusOfTheFile) {
  atom_map::MappingParameters other = coarse();
  other.mode = atom_map::Mode::kSignedDistance;
  ScanServer first(other);
  mapScans(first, 0, 2);
  ASSERT_TRUE(MapStorage(first, {}).save(at(path("map.h5"))).success);
  atom_map::MappingParameters small = coarse();
  small.radius = 0.25;
  ScanServer second(small);
  EXPECT_FALSE(distancesIn(second, drive_.pose(0).translation()).success);
  MapStorage storage(second, {});
  const auto loaded = storage.load(at(path("map.h5")));
  ASSERT_TRUE(loaded.success) << loaded.message;
  EXPECT_NE(loaded.message.find("from now on: signed_distance, 0.5 m"), std::string::npos) << loaded.message;
  EXPECT_EQ(bitsOf(second), bitsOf(first));

  const auto expected = distancesIn(first, drive_.pose(0).translation());
  const auto answer = distancesIn(second, drive_.pose(0).translation());
  ASSERT_TRUE(answer.success) << answer.message;
  EXPECT_GT(std::count(answer.known.begin(), answer.known.end(), 1), 100);
  EXPECT_EQ(answer.known, expected.known);
  EXPECT_EQ(answer.distance, expected.distance);
  EXPECT_EQ(answer.variance, expected.variance);
  EXPECT_EQ(takeSnapshot(second).radius, 0.5F);
  EXPECT_EQ(takeSnapshot(second).mode, atom_map::Mode::kSignedDistance);

  mapScans(first, 2, 3);
  mapScans(second, 2, 3);
  EXPECT_EQ(bitsOf(second), bitsOf(first)) << "mapping goes on in the file's mode and radius";
  ASSERT_TRUE(storage.save(at(path("again.h5"))).success);
  EXPECT_EQ(atom_map::loadMap(path("again.h5")).parameters.radius, 0.5);
}

TEST_F(MapStorageTest, AMapThatWasSavedWithinTheLimitLoadsWithinIt) {
  atom_map::MappingParameters parameters = coarse();
  parameters.limits.max_megabytes = 0.02;
  ScanServer full(parameters);
  mapScans(full, 0, 2);
  const Eigen::Vector3d sensor = drive_.pose(0).translation();
  full.clearRegion({sensor - Eigen::Vector3d::Constant(9.0), sensor + Eigen::Vector3d::Constant(9.0)});
  mapScans(full, 2, 5);
  ASSERT_TRUE(full.limitCounts().is_full);
  ASSERT_TRUE(MapStorage(full, {}).save(at(path("map.h5"))).success);
  const std::vector<float> before = bitsOf(full);
  const auto loaded = MapStorage(full, {}).load(at(path("map.h5")));
  EXPECT_TRUE(loaded.success) << loaded.message;
  EXPECT_EQ(bitsOf(full), before);
}

}  // namespace
}  // namespace atom_mapping
