// Judges the maps of a simulated drive against the scene's exact truth: both modes of the atom map and, made of the same
// returns, OctoMap of equal unit volume.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "atom_mapping/apps/run_program.h"
#include "atom_mapping/evaluation/compared_map.h"
#include "atom_mapping/evaluation/heap_in_use.h"
#include "atom_mapping/evaluation/map_figures.h"
#include "atom_mapping/evaluation/recorded_drive.h"
#include "atom_mapping/evaluation/surface_quality.h"
#include "atom_mapping/io/write_file.h"
#include "atom_mapping/sim/make_scene.h"

namespace {

using atom_map::ComparedMap;
using atom_map::Coverage;
using atom_map::MappingParameters;
using atom_map::RecordedDrive;
using atom_map::Scene;
using atom_map::Share;
using atom_map::SurfaceQuality;
using nlohmann::ordered_json;

constexpr std::uint64_t kSampleSeed = 7;  // of the points that the maps are asked for

struct Options {
  std::string scene = "hall";
  std::vector<double> radii{0.5};
  std::vector<double> slopes;  // deg
  int scans = 40;
  double noise = 0.02;
  std::uint32_t seed = 1;
  bool no_filter = false;
  std::string json;
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--scene", options.scene, "hall, campus, cube, cube_rotated or sphere")->capture_default_str();
  app.add_option("--radius", options.radii, "of the atoms, metres; several may be given")->capture_default_str();
  app.add_option("--slope", options.slopes, "instead of a scene bare ground that rises so many degrees; several");
  app.add_option("--scans", options.scans)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--noise", options.noise, "standard deviation of a range, metres")->capture_default_str();
  app.add_option("--seed", options.seed, "of the noise")->capture_default_str();
  app.add_flag("--no-filter", options.no_filter, "every map gets all returns in range, none is thinned");
  app.add_option("--json", options.json, "write the figures: an object, of several radii or slopes an array");
}

// Inside of these the sensor sees every surface, so that Eq. (13) makes sense.
bool isClosed(const std::string& scene) {
  return scene == "cube" || scene == "cube_rotated" || scene == "sphere";
}

MappingParameters makeParameters(const Options& options) {
  MappingParameters parameters;
  if (options.no_filter) parameters.scan.thinning = 0.0;
  return parameters;
}

RecordedDrive record(const Scene& scene, const atom_map::Trajectory& trajectory, const Options& options) {
  atom_map::LidarModel model;
  model.noise_sigma = options.noise;
  return recordDrive(scene, trajectory, model, options.scans, options.seed, makeParameters(options).scan);
}

std::vector<ComparedMap> mapDrive(const RecordedDrive& drive, double radius, const Options& options) {
  MappingParameters parameters = makeParameters(options);
  parameters.radius = radius;
  std::vector<ComparedMap> maps{makeAtomMap(parameters, atom_map::Mode::kOccupancy),
                                makeAtomMap(parameters, atom_map::Mode::kSignedDistance), makeOctomap(parameters, {})};
  for (const ComparedMap& map : maps) {
    for (std::size_t i = 0; i < drive.scans.size(); ++i) map.insert_scan(drive.scans[i], drive.poses[i]);
  }
  return maps;
}

void print(const char* name, const std::vector<Share>& shares) {
  std::printf("%26s", name);
  for (const Share& share : shares) std::printf(" %6.3f", share.value());
  std::printf("\n%26s", "+-");
  for (const Share& share : shares) std::printf(" %6.3f", atom_map::standardError(share));
  std::printf("\n");
}

ordered_json toJson(const std::vector<Share>& shares, double (*value)(const Share&)) {
  ordered_json all;
  for (const Share& share : shares) all.push_back(value(share));
  return all;
}

void addQuality(const Scene& scene, const std::vector<double>& epsilon, const ComparedMap& map, ordered_json& json) {
  const SurfaceQuality quality = measureSurfaceQuality(scene, epsilon, map.ask, kSampleSeed);
  print("Q", quality.q);
  print("F", quality.f);
  const auto value = [](const Share& share) { return share.value(); };
  json["Q"] = toJson(quality.q, value);
  json["F"] = toJson(quality.f, value);
  json["Q_error"] = toJson(quality.q, atom_map::standardError);
  json["F_error"] = toJson(quality.f, atom_map::standardError);
}

void addCoverage(const Coverage& c, const ComparedMap& map, double radius, ordered_json& json) {
  std::printf("%-22s %6.2f %8.4f %15.4f %9.4f %9.4f %7.4f %10zu\n", map.name.c_str(), radius, c.free.value(),
              c.false_occupied.value(), c.unknown.value(), c.surface.value(), c.thin.value(),
              static_cast<std::size_t>(map.units()));
  json["free"] = c.free.value();
  json["false_occupied"] = c.false_occupied.value();
  json["unknown"] = c.unknown.value();
  json["surface"] = c.surface.value();
  if (c.thin.whole > 0) json["thin"] = c.thin.value();
}

void addSize(const ComparedMap& map, ordered_json& json) {
  json["units"] = map.units();
  json["bytes"] = atom_map::heapReleasedBy(map.release);
}

ordered_json judgeScene(const Scene& scene, const RecordedDrive& drive, double radius, const Options& options) {
  ordered_json figures{{"scene", options.scene}, {"radius", radius}, {"noise", options.noise}};
  const std::vector<double> epsilon = atom_map::distancesFromSurface(radius);
  if (isClosed(options.scene)) figures["epsilon"] = epsilon;
  const auto truth = [&](const Eigen::Vector3d& p) { return scene.signedDistance(p); };
  for (const ComparedMap& map : mapDrive(drive, radius, options)) {
    ordered_json json{{"name", map.name}};
    addCoverage(measureCoverage(drive.rays, radius, map.ask, truth, kSampleSeed), map, radius, json);
    if (isClosed(options.scene)) addQuality(scene, epsilon, map, json);
    addSize(map, json);
    figures["maps"].push_back(json);
  }
  return figures;
}

// Paper, Fig. 9.
ordered_json judgeSlope(double slope, double radius, const Options& options) {
  const RecordedDrive drive = record(atom_map::makeSlope(slope), atom_map::makeClimb(slope), options);
  ordered_json figures{{"slope", slope}, {"radius", radius}, {"noise", options.noise}};
  for (const ComparedMap& map : mapDrive(drive, radius, options)) {
    const Share kept = measureGroundKept(drive.rays, radius, map.ask);
    std::printf("%-22s %6.2f %8.1f %12.4f\n", map.name.c_str(), radius, slope, kept.value());
    ordered_json json{{"name", map.name}, {"ground_kept", kept.value()}};
    addSize(map, json);
    figures["maps"].push_back(json);
  }
  return figures;
}

void run(const Options& options) {
  if (!options.json.empty()) atom_map::checkWritable(options.json);
  ordered_json all;
  if (options.slopes.empty()) {
    const Scene scene = atom_map::makeScene(options.scene);
    const RecordedDrive drive = record(scene, atom_map::makeTrajectory(options.scene), options);
    std::printf("map                    radius     free  falsely occupied   unknown   surface    thin      units\n");
    for (const double radius : options.radii) all.push_back(judgeScene(scene, drive, radius, options));
  } else {
    std::printf("map                    radius    slope  ground kept\n");
    for (const double radius : options.radii) {
      for (const double slope : options.slopes) all.push_back(judgeSlope(slope, radius, options));
    }
  }
  if (!options.json.empty()) atom_map::writeFigures(all, options.json);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Judges the maps of a simulated drive against the scene's exact truth, OctoMap beside the atoms.",
               "evaluate_map");
  Options options;
  addOptions(app, options);
  return atom_mapping::runProgram(app, argc, argv, [&] { run(options); });
}
