#include "atom_mapping/ros/map_storage.h"

#include <chrono>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "atom_mapping/baseline/export_map.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/write_file.h"
#include "atom_mapping/map/forget.h"
#include "atom_mapping/ros/check_request.h"
#include "atom_mapping/ros/frame_name.h"
#include "atom_mapping/ros/map_snapshot.h"

namespace atom_mapping {
namespace {

namespace fs = std::filesystem;

bool isMapFile(const std::string& file) {
  return fs::path(file).extension() == ".h5";
}

void checkEnding(const std::string& file) {
  const std::string ending = fs::path(file).extension().string();
  for (const char* known : {".h5", ".ply", ".pcd", ".csv", ".bt"}) {
    if (ending == known) return;
  }
  throw std::runtime_error("cannot save to " + file +
                           ": name a file that ends in .h5 for the map, in .ply, .pcd or .csv " +
                           "for its atoms, or in .bt for an OctoMap");
}

template <class Value>
void expectSame(const std::string& file, const char* name, const Value& theirs, const Value& ours,
                const char* other_remedy = "") {
  if (theirs == ours) return;
  std::ostringstream text;
  text << "cannot load " << file << ": its " << name << " is " << theirs << " and this node's is " << ours
       << "; load another map, or start the node with " << name << " " << theirs << other_remedy;
  throw std::runtime_error(text.str());
}

std::string toString(atom_map::Mode mode) {
  return mode == atom_map::Mode::kOccupancy ? "occupancy" : "signed_distance";
}

// What a map of another kind is refused with.
[[noreturn]] void refuseKind(const std::string& file, const atom_map::MappingParameters& theirs,
                             const atom_map::MappingParameters& ours) {
  const char* const remedy = ", or call ~reset first: an empty map takes over the file's";
  expectSame(file, "mode", toString(theirs.mode), toString(ours.mode), remedy);
  expectSame(file, "radius", theirs.radius, ours.radius, remedy);
  throw std::runtime_error("cannot load " + file + ": this node's map has just become another; call again");
}

std::string tooLarge(const std::string& file, const atom_map::AtomMap& map, const atom_map::LimitParameters& limits) {
  std::ostringstream text;
  text << "cannot load " << file << ": its " << map.atoms().size() << " atoms (" << 1e-6 * map.atoms().bytes()
       << " MB) are more than this node takes with limits/max_atoms " << limits.max_atoms
       << " and limits/max_megabytes " << limits.max_megabytes
       << " (0: no limit); raise them, load another map, or set limits/policy to forget_farthest";
  return text.str();
}

MapFile::Response done(const std::string& what, std::size_t atoms) {
  MapFile::Response response;
  response.atoms = atoms;
  response.success = 1;
  response.message = what + " " + std::to_string(atoms) + " atoms";
  return response;
}

void checkAutosave(const std::string& file) {
  if (!isMapFile(file)) throw std::runtime_error("autosave is " + file + "; name a file that ends in .h5");
  atom_map::checkWritable(file);
}

// Answers a request by act(), or by what went wrong.
template <class Act>
MapFile::Response answered(Act&& act) {
  try {
    return act();
  } catch (const std::exception& error) {
    MapFile::Response refused;
    refused.success = 0;
    refused.message = error.what();
    return refused;
  }
}

}  // namespace

MapStorage::MapStorage(ScanServer& server, const StorageParameters& parameters)
    : server_(server), parameters_(parameters) {
  const bool begins_anew = parameters_.load == parameters_.autosave && !fs::exists(parameters_.load);
  try {
    if (!parameters_.load.empty() && !begins_anew) loadFrom(checkedFile(parameters_.load));
    if (!parameters_.autosave.empty()) checkAutosave(parameters_.autosave);
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
  return answered([&] {
    const std::string file = checkedFile(request.file);
    checkEnding(file);
    return isMapFile(file) ? saveTo(file) : exportTo(file);
  });
}

MapFile::Response MapStorage::load(const MapFile::Request& request) {
  return answered([&] { return loadFrom(checkedFile(request.file)); });
}

MapFile::Response MapStorage::saveTo(const std::string& file) {
  const std::lock_guard lock(saving_);
  const atom_map::MapCopy copy = atom_map::copyMap(server_.mapper());
  atom_map::saveMap(copy, file);
  return done("saved", copy.size());
}

MapFile::Response MapStorage::exportTo(const std::string& file) {
  const std::lock_guard lock(saving_);
  atom_map::checkMapExport(file);
  const MapSnapshot snapshot = takeSnapshot(server_);
  atom_map::exportMap(toAtomMap(snapshot), file);
  return done("exported", snapshot.atoms.size());
}

MapFile::Response MapStorage::loadFrom(const std::string& file) {
  atom_map::LoadedMap loaded = atom_map::loadMap(file);
  const atom_map::MappingParameters& theirs = loaded.parameters;
  const atom_map::MappingParameters ours = server_.parameters();
  expectSame(file, "map_frame", withoutSlash(theirs.map_frame), withoutSlash(ours.map_frame));
  fit(file, loaded.map);
  MapFile::Response response = done("loaded", loaded.map.atoms().size());
  if (!server_.adopt(std::move(loaded.map), theirs.radius, loaded.scans))
    refuseKind(file, theirs, server_.parameters());
  if (theirs.mode != ours.mode || theirs.radius != ours.radius) {
    std::ostringstream text;
    text << "; mode and radius are those of the file from now on: " << toString(theirs.mode) << ", " << theirs.radius
         << " m";
    response.message += text.str();
    log_.warn("kind", file + ": " + response.message);
  }
  return response;
}

// Choice: the farthest are those from where the sensor was last, and before the first cloud from where the file's map began.
// The window waits for the next cloud.
void MapStorage::fit(const std::string& file, atom_map::AtomMap& map) {
  const atom_map::LimitParameters limits = server_.parameters().limits;
  const atom_map::MapLimit limit = atom_map::limitOf(limits);
  if (limit.holds(map.atoms())) return;
  map.atoms().shrink();  // so that a map which was saved within the limit is
  if (limit.holds(map.atoms())) return;
  if (limits.policy == atom_map::LimitPolicy::kRefuse) throw std::runtime_error(tooLarge(file, map, limits));
  const auto sensor = server_.sensorPose();
  const std::size_t forgotten = forgetFarthest(map, limit, sensor ? sensor->translation() : map.origin());
  log_.warn("fit", "Forgot " + std::to_string(forgotten) + " atoms of " + file +
                       ", those farthest from the sensor, since " +
                       "limits/max_atoms and limits/max_megabytes leave no room for them");
}

void MapStorage::autosave() {
  const std::uint64_t revision = server_.revision();
  if (revision == saved_revision_) return;
  try {
    saveTo(checkedFile(parameters_.autosave));
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
