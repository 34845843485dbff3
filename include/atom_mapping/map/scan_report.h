#pragma once

#include <cstdint>

#include "atom_mapping/map/merge.h"
#include "atom_mapping/scan/filter.h"
#include "atom_mapping/scan/normals.h"

namespace atom_map {

// What became of one scan.
struct ScanReport {
  FilterReport filter;
  NormalReport normals;
  std::uint32_t surface_points = 0;
  std::uint64_t candidates_proposed = 0;     // by ray tracing
  std::uint32_t candidates_interleaved = 0;  // left by interleaving
  std::uint32_t candidates_kept = 0;         // left by the candidate filter
  MergeReport merge;
  std::uint64_t forgotten = 0;  // atoms that the limits let go of, after the merge
  std::uint64_t atoms = 0;      // in the map, after the scan
  std::uint64_t map_bytes = 0;  // heap bytes of the map

  // Wall-clock seconds, a stage each.
  struct Seconds {
    double filter = 0.0;
    double normals = 0.0;
    double rays = 0.0;
    double candidate_filter = 0.0;
    double merge = 0.0;
    double forget = 0.0;
    double total() const { return filter + normals + rays + candidate_filter + merge + forget; }
  } seconds;
};

}  // namespace atom_map
