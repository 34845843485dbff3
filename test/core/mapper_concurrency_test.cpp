// Readers and writers while scans are merged; run under the thread sanitizer too.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

#include "atom_mapping/map/mapper.h"
#include "atom_mapping/query/occupancy.h"
#include "check_map.h"
#include "simulated.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

constexpr double kMaxLogOdds = 3.5;

MappingParameters makeParameters() {
  MappingParameters parameters;
  parameters.radius = 0.25;
  parameters.scan.horizontal_resolution = 1.2;
  return parameters;
}

const Drive& drive() {
  LidarModel model;
  model.firings = 300;
  static const Drive made = makeDrive("hall", 12, 2, model);
  return made;
}

void mapAll(Mapper& mapper) {
  for (std::size_t i = 0; i < drive().scans.size(); ++i) mapper.insertScan(drive().scans[i], drive().poses[i]);
}

std::vector<float> bytesOf(const Mapper& mapper) {
  return mapper.read([](const AtomMap& map) { return bytesOf(map); });
}

// Runs work() over and over in some threads until main_work() is done.
template <class Work, class MainWork>
void runBeside(int threads, Work&& work, MainWork&& main_work) {
  std::atomic<bool> done{false};
  std::atomic<int> rounds{0};
  std::vector<std::thread> beside;
  for (int t = 0; t < threads; ++t) {
    beside.emplace_back([&, t] {
      do {
        work(t);
        ++rounds;
        std::this_thread::yield();
      } while (!done);
    });
  }
  main_work();
  done = true;
  for (std::thread& thread : beside) thread.join();
  EXPECT_GE(rounds, threads);
}

// What every reader sees at every moment.
void expectSound(const Mapper& mapper, int reader) {
  mapper.read([&](const AtomMap& map) {
    std::size_t count = 0;
    map.atoms().forEach([&](ConstAtomRef atom) {
      ++count;
      ASSERT_LE(std::abs(atom.value()), static_cast<float>(kMaxLogOdds));
    });
    ASSERT_EQ(count, map.atoms().size());
    ASSERT_GE(map.atoms().bytes(), count * 16);
    const Eigen::Vector3f sensor = map.toLocal(drive().poses[static_cast<std::size_t>(reader)].translation());
    std::vector<Neighbor> nearest;
    map.atoms().kNearest(sensor, 10, 5.0F, nearest);
    ASSERT_LE(std::abs(interpolate(map, sensor).value_or(0.0F)), static_cast<float>(kMaxLogOdds) * 1.001F);
  });
}

TEST(MapperConcurrency, ReadersSeeASoundMapAtEveryMomentAndDoNotChangeIt) {
  Mapper alone(makeParameters());
  mapAll(alone);
  Mapper mapper(makeParameters());
  runBeside(
      3, [&](int reader) { expectSound(mapper, reader); }, [&] { mapAll(mapper); });
  EXPECT_EQ(bytesOf(mapper), bytesOf(alone)) << "the map should not depend on who reads it";
}

TEST(MapperConcurrency, ReadersSeeASoundMapWhileItForgets) {
  MappingParameters parameters = makeParameters();
  parameters.limits.max_atoms = 4000;
  parameters.limits.policy = LimitPolicy::kForgetFarthest;
  parameters.limits.window = 25.0;
  Mapper alone(parameters);
  mapAll(alone);
  Mapper mapper(parameters);
  runBeside(
      3, [&](int reader) { expectSound(mapper, reader); }, [&] { mapAll(mapper); });
  EXPECT_EQ(bytesOf(mapper), bytesOf(alone)) << "what is forgotten should not depend on who reads";
  EXPECT_LE(mapper.read([](const AtomMap& map) { return map.atoms().size(); }), 4000U);
}

TEST(MapperConcurrency, RegionsMayBeClearedWhileScansAreMerged) {
  Mapper mapper(makeParameters());
  const Vector3d sensor = drive().poses[0].translation();
  const auto clear = [&](int t) {
    const Vector3d low = sensor + Vector3d(t - 2.0, -2.0, -2.0);
    mapper.write([&](AtomMap& map) { map.clearRegion({low, low + Vector3d(2.0, 4.0, 4.0)}); });
    expectSound(mapper, t);
  };
  runBeside(2, clear, [&] { mapAll(mapper); });
  mapper.read([](const AtomMap& map) {
    expectNoOverlap(map);
    expectWithinClamps(map, kMaxLogOdds);
  });
}

TEST(MapperConcurrency, ResetWaitsForTheScanAndStartsAnew) {
  Mapper alone(makeParameters());
  mapAll(alone);
  Mapper mapper(makeParameters());
  runBeside(
      1, [&](int) { mapper.reset(); }, [&] { mapAll(mapper); });
  mapper.read([](const AtomMap& map) { expectNoOverlap(map); });
  mapper.reset();
  mapAll(mapper);
  EXPECT_EQ(bytesOf(mapper), bytesOf(alone));
}

}  // namespace
}  // namespace atom_map
