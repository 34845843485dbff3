// Judges the maps of a simulated drive against the scene's exact truth: both modes of the atom map and, made of the same
// returns, OctoMap of equal unit volume.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "atom_mapping/apps/finite_range.h"
#include "atom_mapping/apps/run_program.h"
#include "atom_mapping/baseline/octomap_baseline.h"
#include "atom_mapping/evaluation/comparison.h"
#include "atom_mapping/evaluation/judge_quality.h"
#include "atom_mapping/evaluation/map_picture.h"
#include "atom_mapping/evaluation/recorded_drive.h"
#include "atom_mapping/io/write_file.h"
#include "atom_mapping/sim/make_scene.h"

namespace {

using atom_map::ComparedMap;
using atom_map::MappingParameters;
using atom_map::RecordedDrive;
using atom_map::Scene;
using atom_mapping::finiteRange;
using nlohmann::ordered_json;

struct Options {
  std::string scene = "hall";
  std::vector<double> radii{0.5};
  std::vector<double> slopes;  // deg
  int scans = 40;
  double noise = 0.02;
  std::uint32_t seed = 1;
  std::size_t stride = 1;
  bool no_filter = false;
  atom_map::MoreOctomaps more;
  bool picture = false;
  std::string json;
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--scene", options.scene, "hall, campus, cube, cube_rotated or sphere")->capture_default_str();
  app.add_option("--radius", options.radii, "of the atoms, metres; several may be given")->capture_default_str();
  app.add_option("--slope", options.slopes, "instead of a scene bare ground that rises so many degrees; several")
      ->check(finiteRange(-80.0, 80.0));
  app.add_option("--scans", options.scans)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--noise", options.noise, "standard deviation of a range, metres")
      ->check(finiteRange(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "of the noise")->capture_default_str();
  app.add_option("--stride", options.stride, "of a scan's rays every so many is asked about")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--no-filter", options.no_filter, "every map gets all returns in range, none is thinned");
  app.add_flag("--pruned", options.more.pruned, "also an OctoMap that joins equal voxels as it grows");
  app.add_flag("--every-return", options.more.every_return, "also an OctoMap whose scans are not thinned");
  app.add_flag("--picture", options.picture, "write every unit too, and of a scene log-odds in the plane z = 0");
  app.add_option("--json", options.json, "write the figures: an object, of several radii or slopes an array");
}

MappingParameters makeParameters(const Options& options) {
  MappingParameters parameters;
  if (options.no_filter) parameters.scan.thinning = 0.0;
  return parameters;
}

RecordedDrive record(const Scene& scene, const atom_map::Trajectory& trajectory, const Options& options) {
  atom_map::LidarModel model;
  model.noise_sigma = options.noise;
  return recordDrive(scene, trajectory, model, options.scans, options.seed, makeParameters(options).scan,
                     options.stride);
}

void print(const std::string& name, const std::vector<double>& values) {
  std::printf("%26s", name.c_str());
  for (const double value : values) std::printf(" %6.3f", value);
  std::printf("\n");
}

// Maps the drive, and adds to `json` for each map what `judge` says of it and what it cost.
ordered_json judgeMaps(const RecordedDrive& drive, double radius, const Options& options,
                       const std::function<ordered_json(const ComparedMap&)>& judge,
                       const atom_map::AskTrueDistance& truth, ordered_json json) {
  MappingParameters parameters = makeParameters(options);
  parameters.radius = radius;
  atom_map::Comparison comparison(makeComparedMaps(parameters, 0.0, options.more));
  for (std::size_t i = 0; i < drive.scans.size(); ++i) comparison.insertScan(drive.scans[i], drive.poses[i]);

  std::vector<ordered_json> judged;
  for (const ComparedMap* map : comparison.maps()) {
    std::printf("%s\n", map->name.c_str());
    judged.push_back(judge(*map));
    if (options.picture) judged.back()["unit_list"] = unitsToJson(*map);
  }
  const std::vector<atom_map::MapFigures> figures = comparison.finish(drive.rays, radius, truth);
  std::cout << toTable(figures) << std::flush;
  for (std::size_t i = 0; i < judged.size(); ++i) {
    json["maps"].push_back(toJson(figures[i]));
    json["maps"].back().update(judged[i]);
  }
  return json;
}

ordered_json judgeScene(const Scene& scene, const RecordedDrive& drive, double radius, const Options& options) {
  const std::vector<double> epsilon = judgedDistances(scene, radius);
  std::printf("\n%s, r = %g m\n", options.scene.c_str(), radius);
  print("epsilon (m)", epsilon);
  const auto judge = [&](const ComparedMap& map) {
    ordered_json quality = judgeQuality(scene, drive, radius, map);
    for (const auto& [name, values] : quality.items()) print(name, values);
    if (options.picture) quality["slice"] = sliceToJson(map, scene.bounds(), radius);
    return quality;
  };
  const auto truth = [&](const Eigen::Vector3d& p) { return scene.signedDistance(p); };
  return judgeMaps(drive, radius, options, judge, truth,
                   {{"scene", options.scene},
                    {"radius", radius},
                    {"voxel", atom_map::equalVolumeVoxel(radius)},
                    {"noise", options.noise},
                    {"epsilon", epsilon}});
}

// Paper, Fig. 9.
ordered_json judgeSlope(double slope, double radius, const Options& options) {
  const RecordedDrive drive = record(atom_map::makeSlope(slope), atom_map::makeClimb(slope), options);
  std::printf("\nslope of %g degrees, r = %g m\n", slope, radius);
  const auto judge = [&](const ComparedMap& map) -> ordered_json {
    const double kept = measureGroundKept(drive.rays, radius, map.ask).value();
    print("ground kept", {kept});
    return {{"ground_kept", kept}};
  };
  return judgeMaps(drive, radius, options, judge, {}, {{"slope", slope}, {"radius", radius}, {"noise", options.noise}});
}

void run(const Options& options) {
  if (!options.json.empty()) atom_map::checkWritable(options.json);
  ordered_json all;
  if (options.slopes.empty()) {
    const Scene scene = atom_map::makeScene(options.scene);
    const RecordedDrive drive = record(scene, atom_map::makeTrajectory(options.scene), options);
    for (const double radius : options.radii) all.push_back(judgeScene(scene, drive, radius, options));
  } else {
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
