// Maps a bag at full speed, as atom_mapping_node would map it live. Needs no roscore.
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "atom_mapping/apps/check_output.h"
#include "atom_mapping/apps/run_program.h"
#include "atom_mapping/baseline/export_map.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/write_mesh.h"
#include "atom_mapping/ros/bag_reader.h"
#include "atom_mapping/ros/bag_summary.h"
#include "atom_mapping/ros/insert_bag.h"
#include "atom_mapping/ros/read_parameters.h"
#include "atom_mapping/ros/scan_server.h"
#include "atom_mapping/surface/extract_surface.h"

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
  std::string surface;
  float surface_resolution = 0.0F;  // m; 0: the radius
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
  app.add_option("--surface", options.surface, "Write the implicit surface, with its variance, to a .ply");
  app.add_option("--surface-resolution", options.surface_resolution, "Side of its cells, metres (the atoms' radius)");
}

atom_map::MappingParameters makeParameters(const Options& options) {
  atom_mapping::ParameterValues values;
  if (!options.config.empty()) values = atom_mapping::readParameterFile(options.config);
  if (options.radius) values["radius"] = *options.radius;
  if (options.mode) values["mode"] = *options.mode;
  return atom_mapping::readParameters(values).mapping;
}

// Why a run mapped nothing.
std::string explain(const BagReader& bag, const ScanServer& server, const BagSummary& summary) {
  const bool lacks_transforms = server.counts().droppedFor(atom_mapping::Drop::kNoTransform) > 0;
  const std::string frames = " (tf knows " + bag.frames() + "; the parameter map_frame names the map's frame)";
  return "nothing was mapped" + (lacks_transforms ? frames : "") + ": " + summary.firstDrop();
}

// Before hours of mapping.
void checkOutputs(const Options& options, double radius) {
  if (!options.save.empty()) atom_mapping::checkOutput(options.save, ".h5");
  for (const std::string& file : options.exports) atom_map::checkMapExport(file);
  if (!options.surface.empty()) atom_map::checkMeshFile(options.surface);
  atom_map::surfaceSpacing(static_cast<float>(radius), options.surface_resolution);
}

void writeSurface(const atom_map::AtomMap& map, const ScanServer& server, const Options& options) {
  atom_map::SurfaceRequest request;
  request.resolution = options.surface_resolution;
  request.threads = std::max(1U, std::thread::hardware_concurrency());
  const atom_map::SurfaceMesh mesh = atom_map::extractSurface(map, server.parameters(), request);
  atom_map::writeMesh(mesh, options.surface);
  std::cout << "surface           " << mesh.triangles.size() << " triangles\n";
}

void writeFiles(const ScanServer& server, const Options& options) {
  if (!options.save.empty()) atom_map::saveMap(atom_map::copyMap(server.mapper()), options.save);
  server.read([&](const atom_map::AtomMap& map) {
    for (const std::string& file : options.exports) atom_map::exportMap(map, file);
    if (!options.surface.empty()) writeSurface(map, server, options);
  });
}

void run(const Options& options) {
  using Clock = std::chrono::steady_clock;
  ScanServer server(makeParameters(options));
  checkOutputs(options, server.parameters().radius);
  BagReader bag(options.bag, options.cloud_topic);
  const Clock::time_point start = Clock::now();
  BagSummary summary;
  insertBag(bag, options.scans, server, [&](const atom_mapping::ScanOutcome& outcome) { summary.add(outcome); });
  std::cout << options.bag << ", " << bag.cloudTopic() << "\n";
  summary.print(std::chrono::duration<double>(Clock::now() - start).count(), std::cout);
  if (summary.mapped() == 0) throw BadBag(explain(bag, server, summary));
  writeFiles(server, options);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Maps the clouds of a bag at full speed, without a roscore.", "atom_mapping_offline");
  Options options;
  addOptions(app, options);
  return atom_mapping::runProgram(app, argc, argv, [&] { run(options); });
}
