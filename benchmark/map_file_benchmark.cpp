// What it costs to save and to load a map of a million atoms, r = 0.25 m; how large the file is, and for how long a scan waits
// for the copy that is saved.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <memory>

#include "atom_mapping/io/map_file.h"
#include "large_map.h"

namespace atom_map {
namespace {

constexpr std::size_t kMillion = 1000000;  // atoms

const std::string& fileName() {
  static const std::string name = (std::filesystem::temp_directory_path() / "map_file_benchmark.h5").string();
  return name;
}

// Copies of a hall, each a little aside and of its own values, lest compression finds them out.
AtomMap copiesApart(const LargeMap& large) {
  const bool has_variance = large.map().mode() == Mode::kSignedDistance;
  AtomMap map(large.map().mode(), large.parameters().radius);
  Random random(1);
  large.map().atoms().forEach([&](const ConstAtomRef& atom) {
    const Eigen::Vector3f copy = (atom.center() / LargeMap::kSpacing).array().round();
    const Eigen::Vector3f aside(0.7371F * copy.y(), 1.3137F * copy.x(), 0.0F);
    const float change = has_variance ? 1.0F + 1e-4F * random.uniform() : 1.0F;
    const std::array<float, 2> values{change * atom.value(), has_variance ? atom.value(1) : 0.0F};
    map.atoms().insert(atom.center() + aside, values.data());
  });
  return map;
}

std::unique_ptr<Mapper> makeMapper(Mode mode) {
  const LargeMap large(mode, kMillion);
  auto mapper = std::make_unique<Mapper>(large.parameters());
  mapper->replace(copiesApart(large), 1);
  return mapper;
}

const Mapper& millionAtoms(Mode mode) {
  static const auto occupancy = makeMapper(Mode::kOccupancy);
  static const auto distance = makeMapper(Mode::kSignedDistance);
  return mode == Mode::kOccupancy ? *occupancy : *distance;
}

// The only part of saving that a scan waits for.
void copying(benchmark::State& state, Mode mode) {
  const Mapper& mapper = millionAtoms(mode);
  for (auto _ : state) benchmark::DoNotOptimize(copyMap(mapper));
}

void saving(benchmark::State& state, Mode mode) {
  const Mapper& mapper = millionAtoms(mode);
  for (auto _ : state) saveMap(copyMap(mapper), fileName());
  const auto atoms = static_cast<double>(mapper.read([](const AtomMap& map) { return map.atoms().size(); }));
  state.counters["atoms"] = atoms;
  state.counters["bytes_an_atom"] = static_cast<double>(std::filesystem::file_size(fileName())) / atoms;
}

void loading(benchmark::State& state, Mode mode) {
  saveMap(copyMap(millionAtoms(mode)), fileName());
  for (auto _ : state) benchmark::DoNotOptimize(loadMap(fileName()));
  std::filesystem::remove(fileName());
}

BENCHMARK_CAPTURE(copying, occupancy, Mode::kOccupancy)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(copying, signedDistance, Mode::kSignedDistance)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(saving, occupancy, Mode::kOccupancy)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(saving, signedDistance, Mode::kSignedDistance)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(loading, occupancy, Mode::kOccupancy)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(loading, signedDistance, Mode::kSignedDistance)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace atom_map

BENCHMARK_MAIN();
