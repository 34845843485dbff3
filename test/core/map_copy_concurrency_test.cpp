#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "atom_mapping/map/map_copy.h"
#include "simulated.h"

namespace atom_map {
namespace {

constexpr std::size_t kScans = 8;

MappingParameters coarse() {
  MappingParameters parameters;
  parameters.radius = 0.5;
  parameters.scan.horizontal_resolution = 2.0;
  return parameters;
}

// Whenever a copy is taken, it is the map between two scans, whole.
TEST(MapCopyConcurrency, EveryCopyIsTheMapAfterAsManyScansAsItSays) {
  LidarModel model;
  model.firings = 180;
  const Drive drive = makeDrive("hall", kScans, 3, model);
  std::vector<MapCopy> expected;  // after 0, 1, 2 ... scans
  Mapper alone(coarse());
  for (std::size_t i = 0; i <= kScans; ++i) {
    expected.push_back(copyMap(alone));
    if (i < kScans) alone.insertScan(drive.scans[i], drive.poses[i]);
  }
  ASSERT_GT(expected.back().size(), expected[1].size());

  Mapper mapper(coarse());
  std::atomic<bool> done{false};
  std::atomic<int> copies{0};
  std::thread copying([&] {
    while (!done) {
      const MapCopy copy = copyMap(mapper);
      ASSERT_LE(copy.scans, kScans);
      EXPECT_EQ(copy.columns, expected[copy.scans].columns);
      EXPECT_EQ(copy.origin, expected[copy.scans].origin);
      ++copies;
      std::this_thread::yield();
    }
  });
  for (std::size_t i = 0; i < kScans; ++i) mapper.insertScan(drive.scans[i], drive.poses[i]);
  const int copies_meanwhile = copies;
  while (copies <= copies_meanwhile) std::this_thread::yield();
  done = true;
  copying.join();
}

}  // namespace
}  // namespace atom_map
