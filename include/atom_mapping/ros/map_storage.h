#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "atom_mapping/MapFile.h"
#include "atom_mapping/ros/node_parameters.h"
#include "atom_mapping/ros/scan_server.h"
#include "atom_mapping/ros/throttled_log.h"

namespace atom_mapping {

// The map's files: the one to start from, what the services save and load, and the one that is kept up to date from a
// thread of its own. Scans go on while a file is written.
// Thread safety: any member may be called from any thread; one file is written at a time.
class MapStorage {
 public:
  // Loads storage/load, as load() does. Throws std::invalid_argument where that cannot be, or where storage/autosave cannot be
  // written or is there already and is not the file that is loaded.
  MapStorage(ScanServer& server, const StorageParameters& parameters);
  // Saves to storage/autosave what changed since it was saved last.
  ~MapStorage();
  MapStorage(const MapStorage&) = delete;
  MapStorage& operator=(const MapStorage&) = delete;

  // As MapQueries' answers: never throw, and a file that cannot be loaded leaves the map as it is. A file's map must be of
  // the node's map frame and, unless the node's map is empty and takes over the file's, of its mode and radius. What is saved
  // is told by the file's ending: the map (.h5), or its atoms or space as exportMap writes them. A map beyond limits/max_* is
  // refused or cut, as limits/policy says. The message names the file with its whole path.
  MapFile::Response save(const MapFile::Request& request);
  MapFile::Response load(const MapFile::Request& request);

 private:
  // Throw where it cannot be.
  MapFile::Response saveTo(const std::string& file);
  MapFile::Response exportTo(const std::string& file);
  MapFile::Response loadFrom(const std::string& file);
  void fit(const std::string& file, atom_map::AtomMap& map);
  void autosave();
  void work();

  ScanServer& server_;
  StorageParameters parameters_;
  ThrottledLog log_;
  std::mutex saving_;
  std::uint64_t saved_revision_ = 0;  // of storage/autosave; the worker's alone
  std::mutex mutex_;                  // of what follows
  std::condition_variable changed_;
  bool stopping_ = false;
  std::thread thread_;  // where there is something to keep up to date
};

}  // namespace atom_mapping
