// Maps beside one another on the same scans: what each costs, and how well it agrees with the rays.
#pragma once

#include <cstddef>
#include <vector>

#include "atom_mapping/evaluation/compared_map.h"
#include "atom_mapping/evaluation/map_figures.h"

namespace atom_map {

class Comparison {
 public:
  explicit Comparison(std::vector<ComparedMap> maps);

  // Every map merges the scan, one after the other, so that drift of the machine's speed meets them all.
  // Choice: the first of them changes from scan to scan, since it finds the scan outside of the caches.
  void insertScan(const LidarScan& scan, const Pose& sensor);

  // How many scans there were.
  std::size_t scans() const { return scans_; }

  std::vector<const ComparedMap*> maps() const;

  // In the order of the maps, which are empty thereafter. `radius`, `true_distance`: as measureCoverage.
  std::vector<MapFigures> finish(const std::vector<ObservedRay>& rays, double radius,
                                 const AskTrueDistance& true_distance = {});

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
