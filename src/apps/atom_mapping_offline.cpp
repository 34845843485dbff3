// Maps a bag at full speed, as atom_mapping_node would map it live. Needs no roscore.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "atom_mapping/baseline/export_octree.h"
#include "atom_mapping/io/export_atoms.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/write_file.h"
#include "atom_mapping/ros/bag_progress.h"
#include "atom_mapping/ros/bag_reader.h"
#include "atom_mapping/ros/bag_summary.h"
#include "atom_mapping/ros/read_parameters.h"
#include "atom_mapping/ros/scan_server.h"

namespace {

using atom_mapping::BadBag;
using atom_mapping::BagReader;
using atom_mapping::BagSummary;
using atom_mapping::ScanServer;

struct Options {
  std::string bag;
  std::string config;
  std::string cloud_topic;
  std::optional<double> radius;
  std::optional<std::string> mode;
  std::optional<std::size_t> scans;
  std::string save;
  std::vector<std::string> exports;
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--bag", options.bag, "Recording to map: clouds and tf")->required();
  app.add_option("--config", options.config, "Parameters, as in config/atom_mapping.yaml");
  app.add_option("--radius", options.radius, "Of every atom, metres, whatever the parameters say");
  app.add_option("--mode", options.mode, "occupancy or signed_distance, whatever the parameters say");
  app.add_option("--topic", options.cloud_topic, "Of the clouds (the only one, or /velodyne_points)");
  app.add_option("--scans", options.scans, "Map so many, no more")->check(CLI::Range(1, 1000000000));
  app.add_option("--save", options.save, "Write the map to a file that the node, map_info and HDF5's tools read (.h5)");
  app.add_option("--export", options.exports,
                 "Write the atoms to a .ply, .pcd or .csv, or the space to OctoMap's .bt; may be given several times");
}

atom_map::MappingParameters makeParameters(const Options& options) {
  atom_mapping::ParameterValues values;
  if (!options.config.empty()) values = atom_mapping::readParameterFile(options.config);
  if (options.radius) values["radius"] = *options.radius;
  if (options.mode) values["mode"] = *options.mode;
  return atom_mapping::readParameters(values).mapping;
}

BagSummary mapBag(BagReader& bag, std::size_t scans, ScanServer& server) {
  atom_mapping::BagProgress progress(scans, std::cerr, isatty(STDERR_FILENO) == 1);
  BagSummary summary;
  for (std::size_t i = 0; i < scans; ++i) {
    const auto cloud = bag.next();
    if (!cloud) break;
    summary.add(server.insert(*cloud, bag.transforms()));
    progress.step();
  }
  return summary;
}

// Why a run mapped nothing.
std::string explain(const BagReader& bag, const ScanServer& server, const BagSummary& summary) {
  const bool lacks_transforms = server.counts().droppedFor(atom_mapping::Drop::kNoTransform) > 0;
  const std::string frames = " (tf knows " + bag.frames() + "; the parameter map_frame names the map's frame)";
  return "nothing was mapped" + (lacks_transforms ? frames : "") + ": " + summary.firstDrop();
}

bool isOctree(const std::string& file) {
  return std::filesystem::path(file).extension() == ".bt";
}

void run(const Options& options) {
  using Clock = std::chrono::steady_clock;
  ScanServer server(makeParameters(options));
  if (!options.save.empty()) atom_map::checkWritable(options.save);
  for (const std::string& file : options.exports) {
    isOctree(file) ? atom_map::checkWritable(file) : atom_map::checkExportFile(file);
  }
  BagReader bag(options.bag, options.cloud_topic);
  if (!bag.hasTransforms()) throw BadBag(options.bag + " holds no tf: record /tf and /tf_static beside the clouds");
  if (bag.clouds() == 0) throw BadBag(options.bag + " holds not one cloud on " + bag.cloudTopic());

  const Clock::time_point start = Clock::now();
  const BagSummary summary = mapBag(bag, std::min(options.scans.value_or(bag.clouds()), bag.clouds()), server);
  std::cout << options.bag << ", " << bag.cloudTopic() << "\n";
  summary.print(std::chrono::duration<double>(Clock::now() - start).count(), std::cout);
  if (summary.mapped() == 0) throw BadBag(explain(bag, server, summary));
  if (!options.save.empty()) atom_map::saveMap(atom_map::copyMap(server.mapper()), options.save);
  for (const std::string& file : options.exports) {
    const auto write = isOctree(file) ? atom_map::exportOctree : atom_map::exportAtoms;
    server.mapper().read([&](const atom_map::AtomMap& map) { write(map, file); });
  }
}

int fail(const std::string& message) {
  std::cerr << "atom_mapping_offline: " << message << std::endl;
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Maps the clouds of a bag at full speed, without a roscore.");
  Options options;
  addOptions(app, options);
  try {
    app.parse(argc, argv);
    run(options);
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? app.exit(error) : fail(error.what());
  } catch (const std::exception& error) {
    return fail(error.what());
  }
  return 0;
}
