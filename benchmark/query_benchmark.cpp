// What queries cost on a map of a million atoms, r = 0.25 m, by one thread. Only a whole surface is of 100,000 atoms and two
// threads.
#include <benchmark/benchmark.h>

#include "atom_mapping/planning/plan_path.h"
#include "atom_mapping/query/cast_ray.h"
#include "atom_mapping/query/collision.h"
#include "atom_mapping/query/gaussian_process.h"
#include "atom_mapping/query/occupancy.h"
#include "atom_mapping/surface/extract_surface.h"
#include "large_map.h"

namespace atom_map {
namespace {

constexpr std::size_t kMillion = 1000000;  // atoms
constexpr std::size_t kQueries = 1 << 15;  // different ones, asked again and again
constexpr float kRobotRadius = 0.3F;       // m
constexpr float kRayLength = 20.0F;        // m

const LargeMap& millionAtoms(Mode mode) {
  static const LargeMap occupancy(Mode::kOccupancy, kMillion);
  static const LargeMap distance(Mode::kSignedDistance, kMillion);
  return mode == Mode::kOccupancy ? occupancy : distance;
}

// Calls ask(query) for one after another.
template <class Query, class Ask>
void askEach(benchmark::State& state, const std::vector<Query>& queries, const Ask& ask) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(ask(queries[i]));
    i = (i + 1) % queries.size();
  }
  state.SetItemsProcessed(state.iterations());
}

void interpolatedOccupancy(benchmark::State& state) {
  const LargeMap& large = millionAtoms(Mode::kOccupancy);
  askEach(state, large.drawPoints(kQueries, 1), [&](const auto& point) { return interpolate(large.map(), point); });
}
BENCHMARK(interpolatedOccupancy);

void regressedOccupancy(benchmark::State& state) {
  const LargeMap& large = millionAtoms(Mode::kOccupancy);
  GaussianProcess process(large.map(), large.parameters().gaussian_process);
  askEach(state, large.drawPoints(kQueries, 1), [&](const auto& point) { return process.estimate(point); });
}
BENCHMARK(regressedOccupancy);

// Near surfaces, where the map knows them.
void signedDistances(benchmark::State& state) {
  const LargeMap& large = millionAtoms(Mode::kSignedDistance);
  GaussianProcess process(large.map(), large.parameters().gaussian_process);
  Random random(2);
  std::vector<Eigen::Vector3f> points;
  for (const MapRay& ray : large.drawRays(kQueries, 0.0F, 1)) {
    const Eigen::Vector3f back = (ray.sensor - ray.end).normalized();
    points.emplace_back(ray.end + 2.0F * large.map().radius() * random.uniform() * back);
  }
  askEach(state, points, [&](const auto& point) { return process.estimate(point); });
}
BENCHMARK(signedDistances);

void collisionSpheres(benchmark::State& state, bool unknown_is_free) {
  const LargeMap& large = millionAtoms(Mode::kOccupancy);
  askEach(state, large.drawPoints(kQueries, 1),
          [&](const auto& center) { return collides(large.map(), center, kRobotRadius, unknown_is_free); });
}
BENCHMARK_CAPTURE(collisionSpheres, unknownIsFree, true);
BENCHMARK_CAPTURE(collisionSpheres, unknownCollides, false);

void raysInOccupancy(benchmark::State& state) {
  const LargeMap& large = millionAtoms(Mode::kOccupancy);
  double length = 0.0;
  askEach(state, large.drawRays(kQueries, kRayLength, 1), [&](const MapRay& ray) {
    const CastRay cast = castRay(large.map(), ray.sensor, (ray.end - ray.sensor).normalized(), kRayLength);
    length += static_cast<double>(cast.distance);
    return cast;
  });
  state.counters["mean_length"] = benchmark::Counter(length, benchmark::Counter::kAvgIterations);
}
BENCHMARK(raysInOccupancy);

// Towards surfaces, since atoms lie near these only.
void raysInSignedDistance(benchmark::State& state) {
  const LargeMap& large = millionAtoms(Mode::kSignedDistance);
  GaussianProcess distances(large.map(), large.parameters().gaussian_process);
  double length = 0.0;
  askEach(state, large.drawRays(kQueries, 0.0F, 1), [&](const MapRay& ray) {
    const Eigen::Vector3f direction = (ray.end - ray.sensor).normalized();
    const Eigen::Vector3f origin = ray.end - std::min(1.0F, (ray.end - ray.sensor).norm()) * direction;
    const CastRay cast = castRay(large.map(), distances, origin, direction, kRayLength);
    length += static_cast<double>(cast.distance);
    return cast;
  });
  state.counters["mean_length"] = benchmark::Counter(length, benchmark::Counter::kAvgIterations);
}
BENCHMARK(raysInSignedDistance);

void wholeSurface(benchmark::State& state, Mode mode) {
  const LargeMap large(mode, kMillion / 10);
  SurfaceRequest request;
  request.threads = 2;
  for (auto _ : state) benchmark::DoNotOptimize(extractSurface(large.map(), large.parameters(), request));
}
BENCHMARK_CAPTURE(wholeSurface, occupancy, Mode::kOccupancy)->Unit(benchmark::kSecond)->Iterations(1)->UseRealTime();
BENCHMARK_CAPTURE(wholeSurface, signedDistance, Mode::kSignedDistance)
    ->Unit(benchmark::kSecond)
    ->Iterations(1)
    ->UseRealTime();

// Between two places on the rays of one hall.
void paths(benchmark::State& state) {
  const LargeMap& large = millionAtoms(Mode::kOccupancy);
  const LargeMap hall(Mode::kOccupancy, 1);
  const auto starts = hall.drawPoints(100, 1);
  const auto goals = hall.drawPoints(100, 2);
  std::vector<PathRequest> requests;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    requests.push_back({large.map().toMap(starts[i]), large.map().toMap(goals[i]), {}});
  }
  askEach(state, requests, [&](const PathRequest& request) {
    return planPath([&](const auto& use) { use(large.map()); }, request, large.parameters().gaussian_process);
  });
}
BENCHMARK(paths)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace atom_map

BENCHMARK_MAIN();
