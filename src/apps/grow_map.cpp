// grow_map: what a scan costs in a map of ten million atoms. Drives through copies of a scene, side by side.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "atom_mapping/apps/check_output.h"
#include "atom_mapping/apps/run_program.h"
#include "atom_mapping/evaluation/growth.h"
#include "atom_mapping/evaluation/map_figures.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/write_file.h"
#include "atom_mapping/sim/make_scene.h"

namespace {

struct Options {
  std::string scene = "campus";
  std::string mode = "occupancy";
  double radius = 0.25;
  std::uint64_t atoms = 10000000;
  int scans = 40;
  int every = 10;
  std::string json;
  std::string save;
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--scene", options.scene, "of which copies are driven through")->capture_default_str();
  app.add_option("--mode", options.mode)->check(CLI::IsMember({"occupancy", "signed_distance"}))->capture_default_str();
  app.add_option("--radius", options.radius, "of the atoms, metres")->capture_default_str();
  app.add_option("--atoms", options.atoms, "that the map shall hold at the end")->capture_default_str();
  app.add_option("--scans", options.scans, "in each copy")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--every", options.every, "so many of the drive's scans one is mapped")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--json", options.json, "write the figures");
  app.add_option("--save", options.save, "write the map, a .h5");
}

// Of a slower lidar, so that its scans lie further apart; what its rays say is not asked.
atom_map::RecordedDrive record(const atom_map::Scene& scene, const Options& options) {
  constexpr std::size_t kHardlyAny = std::numeric_limits<std::size_t>::max() / 2;  // rays
  atom_map::LidarModel model;
  model.period *= options.every;
  return recordDrive(scene, atom_map::makeTrajectory(options.scene), model, options.scans, 1, {}, kHardlyAny);
}

void print(const atom_map::GrowthStep& step) {
  std::printf("%9llu atoms %6.1f MB %7.2f ms a scan, 95 %% %7.2f, slowest %7.2f; merging at most %7.2f ms\n",
              static_cast<unsigned long long>(step.atoms), 1e-6 * static_cast<double>(step.bytes),
              step.milliseconds.mean, step.milliseconds.p95, step.slowest, step.slowest_merging);
  std::fflush(stdout);
}

void run(const Options& options) {
  if (!options.json.empty()) atom_map::checkWritable(options.json);
  if (!options.save.empty()) atom_mapping::checkOutput(options.save, ".h5");
  const atom_map::Scene scene = atom_map::makeScene(options.scene);
  atom_map::MappingParameters parameters;
  parameters.radius = options.radius;
  if (options.mode == "signed_distance") parameters.mode = atom_map::Mode::kSignedDistance;
  const double spacing = scene.bounds().sizes().maxCoeff() + 2.0 * parameters.scan.max_range;
  atom_map::Mapper mapper(parameters);
  nlohmann::ordered_json figures{
      {"scene", options.scene}, {"mode", options.mode}, {"radius", options.radius}, {"scans", options.scans}};
  for (const auto& step : growMap(record(scene, options), spacing, options.atoms, mapper, print)) {
    figures["steps"].push_back(toJson(step));
  }
  if (!options.json.empty()) atom_map::writeFigures({figures}, options.json);
  if (!options.save.empty()) atom_map::saveMap(atom_map::copyMap(mapper), options.save);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Drives through copies of a scene, side by side: what a scan costs as the map grows.", "grow_map");
  Options options;
  addOptions(app, options);
  return atom_mapping::runProgram(app, argc, argv, [&] { run(options); });
}
