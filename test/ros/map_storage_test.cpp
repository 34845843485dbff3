#include "atom_mapping/ros/map_storage.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "atom_mapping/baseline/export_map.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/map/map_limit.h"
#include "atom_mapping/ros/map_queries.h"
#include "atom_mapping/ros/map_snapshot.h"
#include "simulated_input.h"

namespace atom_mapping {
namespace {

namespace fs = std::filesystem;
using atom_map::AtomMap;

std::string contents(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Every bit of a server's map, in its order.
std::vector<float> bitsOf(const ScanServer& server) {
  const atom_map::MapCopy copy = atom_map::copyMap(server.mapper());
  std::vector<float> bits;
  for (const std::vector<float>& column : copy.columns) bits.insert(bits.end(), column.begin(), column.end());
  for (const double x : copy.origin) bits.push_back(static_cast<float>(x));
  return bits;
}

MapFile::Request at(const std::string& file) {
  MapFile::Request request;
  request.file = file;
  return request;
}

atom_map::MappingParameters coarse() {
  atom_map::MappingParameters parameters;
  parameters.radius = 0.5;
  parameters.scan.horizontal_resolution = 2.0;
  return parameters;
}

class MapStorageTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  void mapScans(ScanServer& server, int begin, int end) {
    for (int i = begin; i < end; ++i) {
      transforms_.setTransform(drive_.transform(i), "test");
      ASSERT_FALSE(server.insert(drive_.cloud(i), transforms_).drop);
    }
  }

  void expectRefused(MapStorage& storage, const std::string& file, const std::string& message) {
    const std::uint64_t revision = server_.revision();
    const auto response = storage.load(at(file));
    EXPECT_FALSE(response.success);
    EXPECT_NE(response.message.find(message), std::string::npos) << response.message;
    EXPECT_EQ(response.atoms, 0U);
    EXPECT_EQ(server_.revision(), revision);
  }

  std::string saveOther(const atom_map::MappingParameters& parameters) {
    ScanServer other(parameters);
    mapScans(other, 0, 1);
    EXPECT_TRUE(MapStorage(other, {}).save(at(path("other.h5"))).success);
    return path("other.h5");
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("map_storage_" + std::to_string(getpid()));
  SimulatedDrive drive_ = makeCoarseDrive();
  tf2::BufferCore transforms_;
  ScanServer server_{coarse()};
};

TEST_F(MapStorageTest, SavedResetAndLoadedIsTheSameMap) {
  MapStorage storage(server_, {});
  mapScans(server_, 0, 3);
  const std::vector<float> before = bitsOf(server_);
  const auto saved = storage.save(at(path("map.h5")));
  ASSERT_TRUE(saved.success) << saved.message;
  EXPECT_EQ(saved.atoms, server_.read([](const AtomMap& map) { return map.atoms().size(); }));
  EXPECT_GT(saved.atoms, 100U);
  server_.reset();
  const std::uint64_t revision = server_.revision();
  const auto loaded = storage.load(at(path("map.h5")));
  ASSERT_TRUE(loaded.success) << loaded.message;
  EXPECT_EQ(loaded.atoms, saved.atoms);
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

TEST_F(MapStorageTest, AMapOfAnotherKindIsRefusedWithTheRemedy) {
  MapStorage storage(server_, {});
  mapScans(server_, 0, 1);
  atom_map::MappingParameters other = coarse();
  other.radius = 0.25;
  expectRefused(
      storage, saveOther(other),
      "its radius is 0.25 and this node's is 0.5; load another map, or start the node with radius 0.25, or call "
      "~reset first");
  other = coarse();
  other.mode = atom_map::Mode::kSignedDistance;
  const std::vector<float> before = bitsOf(server_);
  expectRefused(storage, saveOther(other), "its mode is signed_distance and this node's is occupancy; load another");
  EXPECT_EQ(bitsOf(server_), before);
  EXPECT_EQ(server_.parameters().mode, atom_map::Mode::kOccupancy);
  server_.reset();
  EXPECT_TRUE(storage.load(at(path("other.h5"))).success) << "the remedy";
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

TEST_F(MapStorageTest, AMapToStartFromGivesTheNodeItsModeAndRadius) {
  atom_map::MappingParameters other = coarse();
  other.mode = atom_map::Mode::kSignedDistance;
  other.radius = 0.4;  // which no float holds
  const StorageParameters parameters{saveOther(other), path("left.h5"), 1e6};
  {
    const MapStorage storage(server_, parameters);
    EXPECT_EQ(server_.parameters().mode, atom_map::Mode::kSignedDistance);
    EXPECT_EQ(server_.parameters().radius, 0.4);
    server_.clearRegion({Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  }
  EXPECT_EQ(contents(path("left.h5")), contents(path("other.h5")));
}

TEST_F(MapStorageTest, AMapInAnotherFrameIsRefusedAndASlashIsNone) {
  MapStorage storage(server_, {});
  atom_map::MappingParameters other = coarse();
  other.map_frame = "odom";
  atom_map::saveMap(atom_map::copyMap(atom_map::Mapper(other)), path("odom.h5"));
  expectRefused(storage, path("odom.h5"), "its map_frame is odom and this node's is map; load another");
  other.map_frame = "/map";
  atom_map::saveMap(atom_map::copyMap(atom_map::Mapper(other)), path("slash.h5"));
  EXPECT_TRUE(storage.load(at(path("slash.h5"))).success);
}

TEST_F(MapStorageTest, AMapLargerThanTheLimitIsRefusedWithTheRemedyOrForgotten) {
  mapScans(server_, 0, 3);
  ASSERT_TRUE(MapStorage(server_, {}).save(at(path("map.h5"))).success);
  const std::size_t all = server_.read([](const AtomMap& map) { return map.atoms().size(); });
  for (const bool by_bytes : {false, true}) {
    atom_map::MappingParameters parameters = coarse();
    if (!by_bytes) parameters.limits.max_atoms = static_cast<std::uint32_t>(all / 2);
    if (by_bytes) parameters.limits.max_megabytes = 12e-6 * static_cast<double>(all);
    ScanServer refusing(parameters);
    mapScans(refusing, 0, 1);
    const std::vector<float> before = bitsOf(refusing);
    const auto refused = MapStorage(refusing, {}).load(at(path("map.h5")));
    EXPECT_FALSE(refused.success);
    const std::string atoms = "its " + std::to_string(all) + " atoms (";
    EXPECT_NE(refused.message.find(atoms), std::string::npos) << refused.message;
    EXPECT_NE(refused.message.find("set limits/policy to forget_farthest"), std::string::npos) << refused.message;
    EXPECT_EQ(bitsOf(refusing), before);
    EXPECT_THROW(MapStorage(refusing, {path("map.h5"), "", 60.0}), std::invalid_argument);

    parameters.limits.policy = atom_map::LimitPolicy::kForgetFarthest;
    ScanServer forgetting(parameters);
    const auto loaded = MapStorage(forgetting, {}).load(at(path("map.h5")));
    ASSERT_TRUE(loaded.success) << loaded.message;
    EXPECT_GT(loaded.atoms, all / 4);
    forgetting.read([&](const AtomMap& map) {
      EXPECT_EQ(map.atoms().size(), loaded.atoms);
      EXPECT_TRUE(atom_map::limitOf(parameters.limits).holds(map.atoms()));
    });
  }
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

TEST_F(MapStorageTest, AFileThatIsNotThereOrDamagedIsRefusedAndTheMapStays) {
  MapStorage storage(server_, {});
  mapScans(server_, 0, 1);
  const std::vector<float> before = bitsOf(server_);
  expectRefused(storage, path("none.h5"), "cannot load " + path("none.h5") + ": No such file or directory");
  expectRefused(storage, "", "file is empty; name one");
  ASSERT_TRUE(storage.save(at(path("map.h5"))).success);
  fs::resize_file(path("map.h5"), 5000);
  expectRefused(storage, path("map.h5"), "it is cut short");
  EXPECT_EQ(bitsOf(server_), before);
}

TEST_F(MapStorageTest, OtherEndingsExportTheAtomsAsTheOfflineToolDoes) {
  for (const auto mode : {atom_map::Mode::kOccupancy, atom_map::Mode::kSignedDistance}) {
    atom_map::MappingParameters parameters = coarse();
    parameters.mode = mode;
    ScanServer server(parameters);
    mapScans(server, 0, 2);
    MapStorage storage(server, {});
    for (const char* ending : {".ply", ".pcd", ".csv", ".bt"}) {
      const auto saved = storage.save(at(path(std::string("a") + ending)));
      ASSERT_TRUE(saved.success) << saved.message;
      EXPECT_EQ(saved.atoms, server.read([](const AtomMap& map) { return map.atoms().size(); }));
      EXPECT_EQ(saved.message, "exported " + std::to_string(saved.atoms) + " atoms");
      server.read([&](const AtomMap& map) { atom_map::exportMap(map, path(std::string("b") + ending)); });
      EXPECT_EQ(contents(path(std::string("a") + ending)), contents(path(std::string("b") + ending)));
      EXPECT_FALSE(storage.load(at(path(std::string("a") + ending))).success) << "atoms alone are no map";
    }
  }
}

TEST_F(MapStorageTest, AnUnknownEndingIsRefusedWithThoseThereAre) {
  MapStorage storage(server_, {});
  for (const char* name : {"map", "map.obj", "map.h5.bak", ".h5", "map.H5"}) {
    const auto response = storage.save(at(path(name)));
    EXPECT_FALSE(response.success) << name;
    EXPECT_EQ(response.message, "cannot save to " + path(name) +
                                    ": name a file that ends in .h5 for the map, in .ply, .pcd or .csv for its atoms, "
                                    "or in .bt for an OctoMap");
    EXPECT_FALSE(fs::exists(path(name)));
  }
}

TEST_F(MapStorageTest, AFileThatCannotBeWrittenIsReported) {
  MapStorage storage(server_, {});
  const auto response = storage.save(at(path("none/map.h5")));
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.message, "cannot write " + path("none/map.h5") + ": No such file or directory");
  EXPECT_EQ(storage.save(at("")).message, "file is empty; name one, such as /tmp/map.h5");
}

TEST_F(MapStorageTest, AMapToStartFromThatCannotBeLoadedStopsTheStart) {
  const auto messageOf = [&](const StorageParameters& parameters) -> std::string {
    try {
      MapStorage(server_, parameters);
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  EXPECT_EQ(messageOf({path("none.h5"), "", 60.0}),
            "storage: cannot load " + path("none.h5") + ": No such file or directory");
  EXPECT_EQ(messageOf({"", path("none/map.h5"), 60.0}),
            "storage: cannot write " + path("none/map.h5") + ": No such file or directory");
  EXPECT_EQ(messageOf({"", path("map.ply"), 60.0}),
            "storage: autosave is " + path("map.ply") + "; name a file that ends in .h5");
  EXPECT_EQ(messageOf({path("map.h5"), path("map.h5"), 60.0}), "") << "the first start of a map that is to last";
}

TEST_F(MapStorageTest, TheNextStartGoesOnWhereTheLastEnded) {
  const StorageParameters parameters{path("map.h5"), path("map.h5"), 1e6};
  {
    const MapStorage storage(server_, parameters);
    mapScans(server_, 0, 2);
    EXPECT_FALSE(fs::exists(path("map.h5")));
  }
  const std::string bytes = contents(path("map.h5"));
  ScanServer next(coarse());
  { const MapStorage storage(next, parameters); }
  EXPECT_EQ(bitsOf(next), bitsOf(server_));
  EXPECT_EQ(contents(path("map.h5")), bytes) << "nothing changed, nothing to save";
}

TEST_F(MapStorageTest, AutosaveFollowsTheMap) {
  const MapStorage storage(server_, {"", path("map.h5"), 0.1});
  for (int i = 0; i < 3; ++i) {
    mapScans(server_, i, i + 1);
    const auto scans = server_.mapper().readBetweenScans([](const AtomMap&, std::uint64_t count) { return count; });
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!fs::exists(path("map.h5")) || atom_map::loadMap(path("map.h5")).scans != scans) {
      ASSERT_LT(std::chrono::steady_clock::now(), deadline);
      std::this_thread::yield();
    }
  }
}

TEST_F(MapStorageTest, AnAutosaveThatFailsIsTriedAgain) {
  fs::create_directories(path("disk"));
  const MapStorage storage(server_, {"", path("disk/map.h5"), 0.1});
  fs::rename(path("disk"), path("away"));
  mapScans(server_, 0, 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  fs::rename(path("away"), path("disk"));
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!fs::exists(path("disk/map.h5"))) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline);
    std::this_thread::yield();
  }
  EXPECT_GT(atom_map::loadMap(path("disk/map.h5")).map.atoms().size(), 0U);
}

// Scans at full speed beside saves at full speed.
TEST_F(MapStorageTest, SavingHoldsNoScanUpForLong) {
  MapStorage storage(server_, {});
  std::atomic<bool> stop{false};
  std::atomic<int> saves{0};
  std::thread saving([&] {
    while (!stop) saves += storage.save(at(path("map.h5"))).success ? 1 : 0;
  });
  mapScans(server_, 0, 30);
  while (saves < 2) std::this_thread::yield();
  stop = true;
  saving.join();
  EXPECT_EQ(server_.counts().mapped, 30U);
  EXPECT_GT(atom_map::loadMap(path("map.h5")).map.atoms().size(), 100U);
}

}  // namespace
}  // namespace atom_mapping
