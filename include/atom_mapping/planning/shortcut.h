#pragma once

#include <chrono>
#include <vector>

#include "atom_mapping/planning/path_search.h"

namespace atom_map {

// Makes a path cheaper: it leaves the atoms where a straight way between two of its points is safe, known and costs less, and
// is pulled tight round what it goes round.
// May be interrupted as PathSearch may; the path is safe at any time.
class Shortcut {
 public:
  // The path's points must be two or more.
  Shortcut(std::vector<Waypoint> path, const PathPreference& preference, const SafetyRules& rules);

  // Goes on until nothing is left to gain or, a straight way late, until the deadline; false if the deadline came first.
  bool advance(const AtomMap& map, std::chrono::steady_clock::time_point deadline);

  // Its points lie two radii apart or nearer, once it has begun to advance.
  const std::vector<Waypoint>& path() const { return path_; }

 private:
  bool replace(const AtomMap& map, std::size_t from, std::size_t to);
  void goOn(bool is_replaced);
  std::size_t longestFrom(std::size_t i) const;
  bool tighten(const AtomMap& map, std::size_t i);
  void tightenNext(const AtomMap& map);

  std::vector<Waypoint> path_;
  PathPreference preference_;
  SafetyRules rules_;
  bool is_dense_ = false;
  int passes_ = 0;  // completed, of straight ways
  int sweeps_ = 0;  // completed, of pulling tight
  bool gains_ = false;
  std::size_t from_ = 0;  // what is tried next: the way from this point
  std::size_t gap_ = 0;   // to the one so much farther on
};

}  // namespace atom_map
