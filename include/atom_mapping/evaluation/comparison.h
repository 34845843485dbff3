// Maps beside one another on the same scans: what each costs, and how well it agrees with the rays.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "atom_mapping/evaluation/compared_map.h"
#include "atom_mapping/evaluation/map_figures.h"
#include "atom_mapping/evaluation/own_thread.h"

namespace atom_map {

class Comparison {
 public:
  // Scans that a map merges before the next map's turn.
  static constexpr std::size_t kTurn = 20;

  explicit Comparison(std::vector<ComparedMap> maps, std::size_t turn = kTurn);

  // Every map merges the scan, when its turn comes.
  // Choice: maps take turns of some scans, so that drift of the machine's speed meets them all, but each has a heap of its
  // own and finds its caches warm for most scans, as it would alone.
  // Choice: the first of them changes from turn to turn.
  void insertScan(const LidarScan& scan, const Pose& sensor);

  // How many scans there were.
  std::size_t scans() const { return scans_; }

  // With all scans merged.
  std::vector<const ComparedMap*> maps();

  // In the order of the maps, which are empty thereafter. `radius`, `true_distance`: as measureCoverage.
  std::vector<MapFigures> finish(const std::vector<ObservedRay>& rays, double radius,
                                 const AskTrueDistance& true_distance = {});

 private:
  struct Entry {
    ComparedMap map;
    std::vector<double> milliseconds;
    MapFigures figures;
    std::unique_ptr<OwnThread> thread;
  };

  struct Scan {
    LidarScan scan;
    Pose sensor;
  };

  void insertWaiting();
  static void insertTimed(const Scan& scan, Entry& entry);

  std::vector<Entry> entries_;
  std::size_t turn_;
  std::vector<Scan> waiting_;
  std::size_t scans_ = 0;
  std::size_t turns_ = 0;
};

}  // namespace atom_map
