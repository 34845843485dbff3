// Maps beside one another on the same scans: what each costs, and how well it agrees with the rays.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "atom_mapping/base/spread.h"
#include "atom_mapping/evaluation/compared_map.h"

namespace atom_map {

struct MapFigures {
  std::string name;
  Spread milliseconds;            // wall-clock time a scan, from points in the sensor's frame to the updated map
  double cpu_milliseconds = 0.0;  // of the process, a scan
  ScanReport::Seconds stages;     // of all scans together; OctoMap's merge is all that follows the filter
  std::uint64_t scans = 0;
  std::uint64_t bytes = 0;  // of heap that the map held, by the allocator's own count
  std::uint64_t units = 0;  // atoms, or leaves of the octree
  Coverage coverage;        // by the rays
};

// {"name", "ms_per_scan": {"mean", "median", "p95"}, "cpu_ms_per_scan", "stages": {...}, "bytes", "units", "free",
// "false_occupied", "unknown", "surface"}; stages in milliseconds a scan.
nlohmann::ordered_json toJson(const MapFigures& figures);

class Comparison {
 public:
  explicit Comparison(std::vector<ComparedMap> maps);

  // Every map merges the scan, one after the other, so that drift of the machine's speed meets them all.
  // Choice: the first of them changes from scan to scan, since it finds the scan outside of the caches.
  void insertScan(const LidarScan& scan, const Pose& sensor);

  // How many scans there were.
  std::size_t scans() const { return scans_; }

  // In the order of the maps, which are empty thereafter. `radius`: of the points to ask for, as measureCoverage.
  std::vector<MapFigures> finish(const std::vector<ObservedRay>& rays, double radius);

 private:
  struct Entry {
    ComparedMap map;
    std::vector<double> milliseconds;
    MapFigures figures;
  };

  static void insertTimed(const LidarScan& scan, const Pose& sensor, Entry& entry);

  std::vector<Entry> entries_;
  std::size_t scans_ = 0;
};

}  // namespace atom_map
