#include "atom_mapping/ros/map_storage.h"

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "atom_mapping/baseline/export_map.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/write_file.h"
#include "atom_mapping/ros/answer_request.h"
#include "atom_mapping/ros/check_request.h"
#include "atom_mapping/ros/fit_to_limits.h"
#include "atom_mapping/ros/loaded_kind.h"
#include "atom_mapping/ros/map_snapshot.h"

namespace atom_mapping {
namespace {

namespace fs = std::filesystem;

bool isMapFile(const std::string& file) {
  return fs::path(file).extension() == ".h5";
}

[[noreturn]] void refuseEnding(const std::string& file) {
  throw std::runtime_error(
      "cannot save to " + file +
      ": name a file that ends in .h5 for the map, in .ply, .pcd or .csv for its atoms, or in .bt " + "for an OctoMap");
}

// `done`: what was done, such as "saved"; `way`: to or from the file.
MapFile::Response tell(const std::string& done, std::size_t atoms, const std::string& way, const std::string& file) {
  MapFile::Response response;
  response.atoms = atoms;
  response.message = done + " " + std::to_string(atoms) + " atoms " + way + " " + file;
  return response;
}

// Also of files that are not there yet.
bool isSameFile(const fs::path& a, const fs::path& b) {
  std::error_code none;
  return a.lexically_normal() == b.lexically_normal() || fs::equivalent(a, b, none);
}

// The first save would put this run's map in the place of another's.
void checkAutosave(const StorageParameters& parameters) {
  const std::string& file = parameters.autosave;
  if (!isMapFile(file)) throw std::runtime_error("autosave is " + file + "; name a file that ends in .h5");
  atom_map::checkWritable(file);
  if (!fs::exists(file) || isSameFile(parameters.load, file)) return;
  throw std::runtime_error("autosave is " + file +
                           ", which is there already and is not the map to start from; set storage/load to it to go on "
                           "with it, or move it away");
}

}  // namespace

MapStorage::MapStorage(ScanServer& server, const StorageParameters& parameters)
    : server_(server), parameters_(parameters) {
  try {
    for (std::string* const file : {&parameters_.load, &parameters_.autosave}) {
      if (!file->empty()) *file = checkedFile(*file);
    }
    if (!parameters_.autosave.empty()) checkAutosave(parameters_);
    const bool begins_anew = !fs::exists(parameters_.load) && isSameFile(parameters_.load, parameters_.autosave);
    if (!parameters_.load.empty() && !begins_anew) loadFrom(parameters_.load);
  } catch (const std::runtime_error& error) {
    throw std::invalid_argument(std::string("storage: ") + error.what());
  }
  saved_revision_ = server_.revision();
  if (!parameters_.autosave.empty()) thread_ = std::thread([this] { work(); });
}

MapStorage::~MapStorage() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_one();
  thread_.join();
  autosave();
}

MapFile::Response MapStorage::save(const MapFile::Request& request) {
  return answered<MapFile::Response>([&](auto& response) {
    const std::string file = checkedFile(request.file);
    if (!isMapFile(file) && !atom_map::isExportable(file)) refuseEnding(file);
    response = isMapFile(file) ? saveTo(file) : exportTo(file);
  });
}

MapFile::Response MapStorage::load(const MapFile::Request& request) {
  return answered<MapFile::Response>([&](auto& response) { response = loadFrom(checkedFile(request.file)); });
}

MapFile::Response MapStorage::saveTo(const std::string& file) {
  const std::lock_guard lock(saving_);
  const atom_map::MapCopy copy = atom_map::copyMap(server_.mapper());
  atom_map::saveMap(copy, file);
  return tell("saved", copy.size(), "to", file);
}

MapFile::Response MapStorage::exportTo(const std::string& file) {
  const std::lock_guard lock(saving_);
  atom_map::checkMapExport(file);
  const MapSnapshot snapshot = takeSnapshot(server_);
  atom_map::exportMap(toAtomMap(snapshot), file);
  return tell("exported", snapshot.atoms.size(), "to", file);
}

MapFile::Response MapStorage::loadFrom(const std::string& file) {
  atom_map::LoadedMap loaded = atom_map::loadMap(file);
  const atom_map::MappingParameters& theirs = loaded.parameters;
  const atom_map::MappingParameters ours = server_.parameters();
  checkFrame(file, theirs, ours);
  fit(file, loaded.map);
  MapFile::Response response = tell("loaded", loaded.map.atoms().size(), "from", file);
  if (!server_.adopt(std::move(loaded.map), theirs.radius, loaded.scans))
    refuseKind(file, theirs, server_.parameters());
  if (theirs.mode != ours.mode || theirs.radius != ours.radius) {
    response.message += "; mode and radius are those of the file from now on: " + describeKind(theirs);
    log_.warn("kind", response.message);
  }
  return response;
}

// Choice: the farthest are those from where the sensor was last, and before the first cloud from where the file's map began.
// The window waits for the next cloud.
void MapStorage::fit(const std::string& file, atom_map::AtomMap& map) {
  const auto sensor = server_.sensorPose();
  const Eigen::Vector3d place = sensor ? Eigen::Vector3d(sensor->translation()) : map.origin();
  const std::size_t forgotten = fitToLimits("cannot load " + file, server_.parameters().limits, place, map);
  if (forgotten == 0) return;
  log_.warn("fit", "Forgot " + std::to_string(forgotten) + " atoms of " + file +
                       ", those farthest from the sensor, since " +
                       "limits/max_atoms and limits/max_megabytes leave no room for them");
}

void MapStorage::autosave() {
  const std::uint64_t revision = server_.revision();
  if (revision == saved_revision_) return;
  try {
    saveTo(parameters_.autosave);
    saved_revision_ = revision;
  } catch (const std::runtime_error& error) {
    log_.warn("autosave", std::string("The map is not saved: ") + error.what());
  }
}

void MapStorage::work() {
  const auto period = std::chrono::duration<double>(parameters_.autosave_period);
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, period, [this] { return stopping_; })) {
    lock.unlock();
    autosave();
    lock.lock();
  }
}

}  // namespace atom_mapping
