// Clouds, queries, snapshots, saves, loads and resets at once, as the node's threads have them; under the thread sanitizer too.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <boost/make_shared.hpp>
#include <functional>
#include <thread>

#include "../test_folder.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/ros/map_queries.h"
#include "atom_mapping/ros/map_snapshot.h"
#include "atom_mapping/ros/map_storage.h"
#include "atom_mapping/ros/scan_worker.h"
#include "simulated_input.h"

namespace atom_mapping {
namespace {

using atom_map::AtomMap;

constexpr int kClouds = 24;

atom_map::MappingParameters coarse() {
  atom_map::MappingParameters parameters;
  parameters.radius = 0.5;
  parameters.scan.horizontal_resolution = 2.0;
  return parameters;
}

// Repeats each act in a thread of its own until all were done `least` times and `done` holds.
void repeatAtOnce(const std::vector<std::function<void()>>& acts, int least, const std::function<bool()>& done) {
  std::vector<std::atomic<int>> rounds(acts.size());
  const auto enough = [&] {
    return done() && std::all_of(rounds.begin(), rounds.end(), [&](const auto& count) { return count >= least; });
  };
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < acts.size(); ++i) {
    threads.emplace_back([&, i] {
      while (!enough()) {
        acts[i]();
        ++rounds[i];
        std::this_thread::yield();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

class ServerConcurrency : public FolderTest {
 protected:
  void SetUp() override {
    for (int i = 0; i < kClouds; ++i) {
      transforms_.setTransform(drive_.transform(i), "test");
      clouds_.push_back(boost::make_shared<sensor_msgs::PointCloud2>(drive_.cloud(i)));
    }
  }

  MapFile::Request at(const std::string& name) const {
    MapFile::Request request;
    request.file = path(name);
    return request;
  }

  void expectSensibleAnswers() {
    QueryOccupancy::Request points;
    points.points.resize(50);
    for (std::size_t i = 0; i < points.points.size(); ++i) points.points[i].x = 0.3 * static_cast<double>(i);
    const auto states = queries_.answer(points);
    ASSERT_TRUE(states.success) << states.message;
    for (std::size_t i = 0; i < states.state.size(); ++i) {
      EXPECT_EQ(states.state[i] == QueryOccupancy::Response::OCCUPIED, states.probability[i] > 0.5F);
    }
  }

  void expectWholeSnapshot() const {
    for (const MapSnapshot::Atom& atom : takeSnapshot(server_).atoms) {
      ASSERT_TRUE(atom.center.allFinite() && std::abs(atom.values[0]) <= 3.5F);
    }
  }

  SimulatedDrive drive_ = makeCoarseDrive();
  std::vector<ScanWorker::CloudPtr> clouds_;
  tf2::BufferCore transforms_;
  ScanServer server_{coarse()};
  MapQueries queries_{server_, transforms_, ServiceParameters{}};
};

// What only reads changes no bit of the map, and none of its copies is torn.
TEST_F(ServerConcurrency, ReadersLeaveTheMapAsItWouldBeWithoutThem) {
  ScanServer alone(coarse());
  for (const auto& cloud : clouds_) ASSERT_FALSE(alone.insert(*cloud, transforms_).drop);
  atom_map::saveMap(atom_map::copyMap(alone.mapper()), path("alone.h5"));

  std::atomic<int> mapped{0};
  {
    MapStorage storage(server_, {"", path("autosave.h5"), 0.1});
    ScanWorker worker(server_, transforms_, kClouds, [&](const auto&, const ScanOutcome& outcome) {
      EXPECT_FALSE(outcome.drop) << outcome.message;
      ++mapped;
    });
    for (const auto& cloud : clouds_) worker.add(cloud);
    repeatAtOnce({[&] { expectSensibleAnswers(); }, [&] { expectWholeSnapshot(); },
                  [&] {
                    const auto saved = storage.save(at("saved.h5"));
                    ASSERT_TRUE(saved.success) << saved.message;
                    EXPECT_EQ(atom_map::loadMap(path("saved.h5")).map.atoms().size(), saved.atoms);
                  }},
                 3, [&] { return mapped == kClouds; });
  }
  const auto columnsOf = [](const ScanServer& server) { return atom_map::copyMap(server.mapper()).columns; };
  EXPECT_GT(columnsOf(alone)[0].size(), 100U);
  EXPECT_EQ(columnsOf(server_), columnsOf(alone));
  EXPECT_EQ(atom_map::loadMap(path("autosave.h5")).scans, static_cast<std::uint64_t>(kClouds));
}

// What changes the map comes between two scans: every cloud is accounted for, and all that is left is whole.
TEST_F(ServerConcurrency, ClearsResetsAndLoadsComeBetweenScans) {
  MapStorage storage(server_, {});
  ASSERT_FALSE(server_.insert(*clouds_[0], transforms_).drop);
  const auto first = storage.save(at("first.h5"));
  ASSERT_TRUE(first.success) << first.message;
  std::atomic<int> done{0};
  ScanWorker worker(server_, transforms_, kClouds, [&](const auto&, const ScanOutcome&) { ++done; });
  for (const auto& cloud : clouds_) worker.add(cloud);
  ClearRegion::Request box;
  box.max.x = box.max.y = box.max.z = 3.0;
  repeatAtOnce({[&] { EXPECT_TRUE(queries_.answer(box).success); }, [&] { EXPECT_TRUE(queries_.reset().success); },
                [&] { EXPECT_EQ(storage.load(at("first.h5")).atoms, first.atoms); }, [&] { expectSensibleAnswers(); },
                [&] { expectWholeSnapshot(); }, [&] { worker.clear(); }},
               3, [&] { return done == kClouds; });
  const ScanCounts counts = server_.counts();
  EXPECT_EQ(counts.mapped + counts.droppedInAll(), static_cast<std::uint64_t>(kClouds) + 1);
  ASSERT_TRUE(storage.save(at("last.h5")).success);
  EXPECT_NO_THROW(atom_map::loadMap(path("last.h5"))) << "atoms overlap, or hold what none can";
}

// Every atom that scans put in and regions took out is accounted for; a reset takes out all, and no call waits for ever.
TEST_F(ServerConcurrency, RegionsAreClearedAndTheMapIsResetUnderLoad) {
  const auto atoms = [&] { return server_.read([](const AtomMap& map) { return map.atoms().size(); }); };
  const auto box_at = [&](int i) {
    const Eigen::Vector3d sensor = drive_.pose(i % kClouds).translation();
    ClearRegion::Request box;
    box.min.x = sensor.x() - 4.0;
    box.min.y = sensor.y() - 4.0;
    box.min.z = sensor.z() - 4.0;
    box.max.x = sensor.x() + 1.0 * (i % 5);
    box.max.y = sensor.y() + 4.0;
    box.max.z = sensor.z() + 4.0;
    return box;
  };
  for (const bool with_resets : {true, false}) {
    server_.reset();
    std::atomic<int> done{0};
    std::atomic<std::uint64_t> inserted{0};
    std::atomic<std::uint64_t> removed{0};
    std::atomic<int> clears{0};
    {
      ScanWorker worker(server_, transforms_, kClouds, [&](const auto&, const ScanOutcome& outcome) {
        inserted += outcome.report.atoms_inserted;
        ++done;
      });
      for (const auto& cloud : clouds_) worker.add(cloud);
      std::vector<std::function<void()>> acts{[&] {
                                                const auto answer = queries_.answer(box_at(clears++));
                                                EXPECT_TRUE(answer.success) << answer.message;
                                                removed += answer.removed;
                                              },
                                              [&] { expectSensibleAnswers(); }, [&] { expectWholeSnapshot(); }};
      if (with_resets) acts.emplace_back([&] { EXPECT_TRUE(queries_.reset().success); });
      repeatAtOnce(acts, 3, [&] { return done == kClouds; });
    }
    if (!with_resets) {
      EXPECT_GT(removed, 0U);
      EXPECT_EQ(atoms(), inserted - removed);
    }
    const std::size_t before = atoms();
    const auto box = box_at(kClouds - 1);
    const std::size_t last = queries_.answer(box).removed;
    EXPECT_EQ(before - last, atoms());
    const Eigen::AlignedBox3d cleared(Eigen::Vector3d(box.min.x, box.min.y, box.min.z),
                                      Eigen::Vector3d(box.max.x, box.max.y, box.max.z));
    server_.read([&](const AtomMap& map) {
      map.atoms().forEach(
          [&](atom_map::ConstAtomRef atom) { EXPECT_FALSE(cleared.contains(map.toMap(atom.center()))); });
    });
  }
  EXPECT_GT(atoms(), 0U);
  EXPECT_TRUE(queries_.reset().success);
  EXPECT_EQ(atoms(), 0U);
}

// An empty map takes over the next file's mode and radius, whatever is asked or mapped meanwhile; one that holds atoms keeps
// its own.
TEST_F(ServerConcurrency, ModeAndRadiusChangeUnderLoad) {
  MapStorage storage(server_, {});
  for (const auto mode : {atom_map::Mode::kOccupancy, atom_map::Mode::kSignedDistance}) {
    atom_map::MappingParameters parameters = coarse();
    parameters.mode = mode;
    parameters.radius = mode == atom_map::Mode::kOccupancy ? 0.5 : 0.4;
    ScanServer other(parameters);
    ASSERT_FALSE(other.insert(*clouds_[0], transforms_).drop);
    const bool is_occupancy = mode == atom_map::Mode::kOccupancy;
    ASSERT_TRUE(MapStorage(other, {}).save(at(is_occupancy ? "occupancy.h5" : "distances.h5")).success);
  }
  std::atomic<int> done{0};
  std::atomic<int> loads{0};
  QuerySignedDistance::Request points;
  points.points.resize(50);
  ScanWorker worker(server_, transforms_, kClouds, [&](const auto&, const ScanOutcome&) { ++done; });
  for (const auto& cloud : clouds_) worker.add(cloud);
  const auto load = [&](const char* name) {
    queries_.reset();
    const auto loaded = storage.load(at(name));
    EXPECT_TRUE(loaded.success || loaded.message.find("cannot load") == 0) << loaded.message;
    loads += loaded.success ? 1 : 0;
  };
  repeatAtOnce({[&] { load("occupancy.h5"); }, [&] { load("distances.h5"); },
                [&] {
                  const auto distances = queries_.answer(points);
                  EXPECT_TRUE(distances.success || distances.message.find("the map is in occupancy mode") == 0);
                },
                [&] { EXPECT_TRUE(queries_.answer(QueryOccupancy::Request()).success); },
                [&] {
                  const auto saved = storage.save(at("saved.h5"));
                  ASSERT_TRUE(saved.success) << saved.message;
                  EXPECT_EQ(atom_map::loadMap(path("saved.h5")).map.atoms().size(), saved.atoms);
                }},
               3, [&] { return done == kClouds && loads > 2; });
  const auto parameters = server_.parameters();
  server_.read([&](const AtomMap& map) {
    EXPECT_EQ(map.mode(), parameters.mode);
    EXPECT_EQ(map.radius(), static_cast<float>(parameters.radius));
  });
}

}  // namespace
}  // namespace atom_mapping
