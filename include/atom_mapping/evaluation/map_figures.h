#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "atom_mapping/base/spread.h"
#include "atom_mapping/map/scan_report.h"
#include "atom_mapping/sim/coverage.h"

namespace atom_map {

// What a map cost, and how well it agrees with the rays.
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
// "false_occupied", "unknown", "surface"}, and "thin" where there was anything thin; stages in milliseconds a scan.
nlohmann::ordered_json toJson(const MapFigures& figures);

// A table, one line a map.
std::string toTable(const std::vector<MapFigures>& maps);

// Writes an array of objects, or its only object alone. Throws as writeFile.
void writeFigures(const nlohmann::ordered_json& all, const std::string& file);

}  // namespace atom_map
