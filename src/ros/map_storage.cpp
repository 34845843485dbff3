#include "atom_mapping/ros/map_storage.h"

#include <chrono>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/write_file.h"
#include "atom_mapping/map/forget.h"
#include "atom_mapping/ros/frame_name.h"

namespace atom_mapping {
namespace {

namespace fs = std::filesystem;

std::string absolute(const std::string& file) {
  if (file.empty()) throw std::runtime_error("file is empty; name one, such as /tmp/map.h5");
  return fs::absolute(file).string();
}

template <class Value>
void expectSame(const std::string& file, const char* name, const Value& theirs, const Value& ours) {
  if (theirs == ours) return;
  std::ostringstream text;
  text << "cannot load " << file << ": its " << name << " is " << theirs << " and this node's is " << ours
       << "; load another map, or start the node with " << name << " " << theirs;
  throw std::runtime_error(text.str());
}

std::string toString(atom_map::Mode mode) {
  return mode == atom_map::Mode::kOccupancy ? "occupancy" : "signed_distance";
}

void checkFits(const std::string& file, const atom_map::MappingParameters& theirs,
               const atom_map::MappingParameters& ours) {
  expectSame(file, "mode", toString(theirs.mode), toString(ours.mode));
  expectSame(file, "radius", theirs.radius, ours.radius);
  expectSame(file, "map_frame", withoutSlash(theirs.map_frame), withoutSlash(ours.map_frame));
}

std::string tooLarge(const std::string& file, const atom_map::AtomMap& map, const atom_map::LimitParameters& limits) {
  std::ostringstream text;
  text << "cannot load " << file << ": its " << map.atoms().size() << " atoms (" << 1e-6 * map.atoms().bytes()
       << " MB) are more than this node takes with limits/max_atoms " << limits.max_atoms
       << " and limits/max_megabytes " << limits.max_megabytes
       << " (0: no limit); raise them, load another map, or set limits/policy to forget_farthest";
  return text.str();
}

// Answers a request by act(), which returns the number of atoms, or by what went wrong.
template <class Act>
MapFile::Response answered(const std::string& what, Act&& act) {
  MapFile::Response response;
  try {
    response.atoms = act();
    response.success = 1;
    response.message = what + " " + std::to_string(response.atoms) + " atoms";
  } catch (const std::exception& error) {
    response.success = 0;
    response.message = error.what();
  }
  return response;
}

}  // namespace

MapStorage::MapStorage(ScanServer& server, const StorageParameters& parameters)
    : server_(server), parameters_(parameters) {
  const bool begins_anew = parameters_.load == parameters_.autosave && !fs::exists(parameters_.load);
  try {
    if (!parameters_.load.empty() && !begins_anew) loadFrom(absolute(parameters_.load));
    if (!parameters_.autosave.empty()) atom_map::checkWritable(parameters_.autosave);
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
  return answered("saved", [&] { return saveTo(absolute(request.file)); });
}

MapFile::Response MapStorage::load(const MapFile::Request& request) {
  return answered("loaded", [&] { return loadFrom(absolute(request.file)); });
}

std::size_t MapStorage::saveTo(const std::string& file) {
  const std::lock_guard lock(saving_);
  const atom_map::MapCopy copy = atom_map::copyMap(server_.mapper());
  atom_map::saveMap(copy, file);
  return copy.size();
}

std::size_t MapStorage::loadFrom(const std::string& file) {
  atom_map::LoadedMap loaded = atom_map::loadMap(file);
  checkFits(file, loaded.parameters, server_.parameters());
  fit(file, loaded.map);
  const std::size_t atoms = loaded.map.atoms().size();
  server_.replace(std::move(loaded.map), loaded.scans);
  return atoms;
}

// Choice: the farthest are those from where the sensor was last, and before the first cloud from where the file's map began.
// The window waits for the next cloud.
void MapStorage::fit(const std::string& file, atom_map::AtomMap& map) {
  const atom_map::LimitParameters& limits = server_.parameters().limits;
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
    saveTo(absolute(parameters_.autosave));
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
