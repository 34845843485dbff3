// What it costs a map of a million atoms, r = 0.25 m, to forget; and for how long a reader waits meanwhile.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "large_map.h"

namespace atom_map {
namespace {

constexpr std::size_t kMillion = 1000000;  // atoms

const LargeMap& town() {
  static const LargeMap large(Mode::kOccupancy, kMillion);
  return large;
}

AtomMap copyOf(const AtomMap& map) {
  AtomMap copy(map.mode(), static_cast<double>(map.radius()));
  copy.anchor(map.origin());
  map.atoms().forEach([&](const ConstAtomRef& atom) {
    const float value = atom.value();
    copy.atoms().insert(atom.center(), &value);
  });
  return copy;
}

// Reads over and over; the longest that it took to be let in, in ms.
class Reader {
 public:
  explicit Reader(const Mapper& mapper) : mapper_(mapper) {}
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() { stop(); }

  double stop() {
    stopping_ = true;
    if (thread_.joinable()) thread_.join();
    return longest_;
  }

 private:
  void work() {
    using Clock = std::chrono::steady_clock;
    while (!stopping_) {
      const Clock::time_point start = Clock::now();
      mapper_.read([](const AtomMap& map) { benchmark::DoNotOptimize(map.atoms().size()); });
      longest_ = std::max(longest_, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
      std::this_thread::yield();
    }
  }

  const Mapper& mapper_;
  std::atomic<bool> stopping_{false};
  double longest_ = 0.0;
  std::thread thread_{[this] { work(); }};
};

// A scan without a return, on a town of a million atoms: all that it does is to forget.
void forgetting(benchmark::State& state, const LimitParameters& limits) {
  MappingParameters parameters = town().parameters();
  parameters.limits = limits;
  Mapper mapper(parameters);
  const Pose sensor(Eigen::Translation3d(town().map().toMap(Eigen::Vector3f(250.0F, 250.0F, 2.0F))));
  for (auto _ : state) {
    mapper.replace(copyOf(town().map()), 1);
    Reader reader(mapper);
    const ScanReport report = mapper.insertScan(LidarScan(), sensor);
    const double longest = reader.stop();
    state.SetIterationTime(report.seconds.forget);
    state.counters["forgotten"] = static_cast<double>(report.forgotten);
    state.counters["left"] = static_cast<double>(report.atoms);
    state.counters["MB"] = 1e-6 * static_cast<double>(report.map_bytes);
    state.counters["reader_waits_ms"] = std::max(longest, state.counters["reader_waits_ms"].value);
  }
}

// What each scan pays while nothing lies beyond the window.
void lookingBeyond(benchmark::State& state) {
  AtomMap map = copyOf(town().map());
  const KeptBall kept = windowAround(map, 200.0, map.toMap(Eigen::Vector3f(250.0F, 250.0F, 2.0F)));
  map.atoms().removeBeyond(kept.center, kept.radius);
  for (auto _ : state) benchmark::DoNotOptimize(map.atoms().removeBeyond(kept.center, kept.radius));
  state.counters["atoms"] = static_cast<double>(map.atoms().size());
}

// A drive of two kilometres, straight on through a corridor with columns: what the map takes on its way.
void driving(benchmark::State& state, double window) {
  constexpr int kMetres = 2000;
  std::vector<Solid> solids{
      {makeBox(Pose(Eigen::Translation3d(1000.0, 0.0, 2.0)), {2200.0, 20.0, 8.0}), SurfaceKind::kWall, true}};
  for (int x = 0; x < kMetres; x += 10) {
    solids.push_back({Cylinder{{1.0 * x, x % 20 - 5.0, -2.0}, 0.3, 8.0}, SurfaceKind::kColumn});
  }
  const Scene scene("corridor", std::move(solids), Eigen::AlignedBox3d(Eigen::Vector3d::Zero()));
  Trajectory straight;
  straight.base_pose = [](double t) { return Pose(Eigen::Translation3d(t, 0.1, 0.0)); };
  LidarModel model;
  model.firings = 600;
  MappingParameters parameters;
  parameters.scan.horizontal_resolution = 0.6;
  parameters.limits.window = window;
  for (auto _ : state) {
    Mapper mapper(parameters);
    for (int x = 0; x <= kMetres; x += 2) {
      const SimulatedScan scan = simulateScan(scene, straight, x, model, 1);
      const ScanReport report = mapper.insertScan(toLidarScan(scan), straight.sensorPose(x));
      if (x % 500 == 0) state.counters["MB_at_" + std::to_string(x)] = 1e-6 * static_cast<double>(report.map_bytes);
      state.counters["slowest_ms"] = std::max(1e3 * report.seconds.forget, state.counters["slowest_ms"].value);
    }
  }
}

constexpr LimitPolicy kForget = LimitPolicy::kForgetFarthest;
BENCHMARK_CAPTURE(forgetting, window_100_m, LimitParameters{0, 0.0, kForget, 100.0})
    ->UseManualTime()
    ->Iterations(10)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(forgetting, a_twentieth, LimitParameters{kMillion, 0.0, kForget, 0.0})
    ->UseManualTime()
    ->Iterations(10)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(forgetting, half, LimitParameters{kMillion / 2, 0.0, kForget, 0.0})
    ->UseManualTime()
    ->Iterations(10)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(driving, whole_map, 0.0)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(driving, window_of_50_m, 50.0)->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(lookingBeyond)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace atom_map

BENCHMARK_MAIN();
