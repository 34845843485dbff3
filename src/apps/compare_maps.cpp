// Both modes of the atom map and OctoMap on the same scans of a bag, in one process: what each costs, and how well it
// agrees with the bag's own rays.
#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "atom_mapping/apps/run_program.h"
#include "atom_mapping/baseline/octomap_baseline.h"
#include "atom_mapping/evaluation/comparison.h"
#include "atom_mapping/io/write_file.h"
#include "atom_mapping/ros/bag_reader.h"
#include "atom_mapping/ros/cloud_server.h"
#include "atom_mapping/ros/insert_bag.h"
#include "atom_mapping/ros/read_parameters.h"

namespace {

using atom_map::Comparison;
using atom_map::MapFigures;
using atom_map::MappingParameters;
using atom_mapping::BadBag;
using atom_mapping::BagReader;

struct Options {
  std::string bag;
  std::string config;
  std::string cloud_topic;
  std::vector<double> radii;
  std::optional<double> max_range;
  std::optional<std::size_t> scans;
  double voxel = 0.0;  // m; 0: of equal volume
  std::size_t stride = 7;
  bool no_filter = false;
  atom_map::MoreOctomaps more;
  std::string json;
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--bag", options.bag, "Recording to map: clouds and tf")->required();
  app.add_option("--config", options.config, "Parameters, as in config/atom_mapping.yaml");
  app.add_option("--radius", options.radii, "Of every atom, metres; several may be given (as the parameters say)");
  app.add_option("--max-range", options.max_range, "Farther returns are discarded, metres (as the parameters say)");
  app.add_option("--topic", options.cloud_topic, "Of the clouds (the only one, or /velodyne_points)");
  app.add_option("--scans", options.scans, "Map so many, no more")->check(CLI::Range(1, 1000000000));
  app.add_option("--voxel", options.voxel, "Side of OctoMap's voxels, metres (of an atom's volume)")
      ->check(CLI::Range(0.01, 100.0));
  app.add_option("--stride", options.stride, "Of a scan's returns every so many is asked about")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  app.add_flag("--no-filter", options.no_filter, "Every map gets all returns in range, none is thinned");
  app.add_flag("--pruned", options.more.pruned, "Also an OctoMap that joins equal voxels as it grows");
  app.add_flag("--every-return", options.more.every_return,
               "Also an OctoMap whose scans are not thinned, as octomap_server's are not");
  app.add_option("--json", options.json, "Write the figures: an object, of several radii an array of them");
}

MappingParameters makeParameters(const Options& options) {
  atom_mapping::ParameterValues values;
  if (!options.config.empty()) values = atom_mapping::readParameterFile(options.config);
  if (options.max_range) values["scan/max_range"] = *options.max_range;
  if (options.no_filter) values["scan/thinning"] = 0.0;
  return atom_mapping::readParameters(values).mapping;
}

// The maps of one radius.
struct Contest {
  double radius;
  double voxel;  // m
  Comparison comparison;
};

Contest makeContest(MappingParameters parameters, double radius, const Options& options) {
  parameters.radius = radius;
  const double voxel = options.voxel > 0.0 ? options.voxel : atom_map::equalVolumeVoxel(radius);
  return {radius, voxel, Comparison(makeComparedMaps(parameters, voxel, options.more))};
}

// Feeds every map, and remembers the rays.
class ContestServer : public atom_mapping::CloudServer {
 public:
  ContestServer(const MappingParameters& parameters, std::size_t stride, std::vector<Contest>& contests)
      : CloudServer(parameters.map_frame, parameters.scan.clear_no_returns),
        parameters_(parameters.scan),
        stride_(stride),
        contests_(contests) {}

  const std::vector<atom_map::ObservedRay>& rays() const { return rays_; }

 private:
  atom_map::ScanReport insertScan(const atom_map::LidarScan& scan, const atom_map::Pose& sensor) override {
    for (Contest& contest : contests_) contest.comparison.insertScan(scan, sensor);
    addRays(scan, sensor, parameters_, stride_, rays_);
    return {};
  }

  atom_map::ScanParameters parameters_;
  std::size_t stride_;
  std::vector<Contest>& contests_;
  std::vector<atom_map::ObservedRay> rays_;
};

void mapBag(const Options& options, ContestServer& server) {
  BagReader bag(options.bag, options.cloud_topic);
  insertBag(bag, options.scans, server, [](const atom_mapping::ScanOutcome&) {});
  const atom_mapping::ScanCounts counts = server.counts();
  if (counts.mapped == 0) throw BadBag("nothing of " + options.bag + " was mapped: " + counts.last_drop);
  if (counts.droppedInAll() == 0) return;
  std::cout << counts.droppedInAll() << " clouds dropped, the last: " << counts.last_drop << "\n";
}

nlohmann::ordered_json toJson(const Options& options, const MappingParameters& parameters, const Contest& contest,
                              const std::vector<MapFigures>& figures) {
  nlohmann::ordered_json maps;
  for (const MapFigures& map : figures) maps.push_back(atom_map::toJson(map));
  return {{"bag", options.bag},
          {"radius", contest.radius},
          {"voxel", contest.voxel},
          {"max_range", parameters.scan.max_range},
          {"scans", contest.comparison.scans()},
          {"maps", maps}};
}

void run(Options options) {
  const MappingParameters parameters = makeParameters(options);
  if (!options.json.empty()) atom_map::checkWritable(options.json);
  if (options.radii.empty()) options.radii.push_back(parameters.radius);
  std::vector<Contest> contests;
  for (const double radius : options.radii) contests.push_back(makeContest(parameters, radius, options));
  ContestServer server(parameters, options.stride, contests);
  mapBag(options, server);

  nlohmann::ordered_json all;
  for (Contest& contest : contests) {
    const std::vector<MapFigures> figures = contest.comparison.finish(server.rays(), contest.radius);
    std::cout << "\nr = " << contest.radius << " m, voxels of " << contest.voxel << " m, " << contest.comparison.scans()
              << " scans\n"
              << atom_map::toTable(figures) << std::flush;
    all.push_back(toJson(options, parameters, contest, figures));
  }
  if (!options.json.empty()) atom_map::writeFigures(all, options.json);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Maps a bag by atoms and by OctoMap side by side: time, memory, agreement with its rays.",
               "compare_maps");
  Options options;
  addOptions(app, options);
  return atom_mapping::runProgram(app, argc, argv, [&] { run(options); });
}
