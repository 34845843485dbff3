#pragma once

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "atom_mapping/ros/scan_server.h"

namespace atom_mapping {

// What a run over a bag came to.
class BagSummary {
 public:
  void add(const ScanOutcome& outcome);

  std::size_t mapped() const { return reports_.size(); }
  const std::string& firstDrop() const { return first_drop_; }

  // Some lines of text. `seconds`: wall time of the whole run.
  void print(double seconds, std::ostream& out) const;

 private:
  void printScans(double seconds, std::ostream& out) const;
  void printPoints(std::ostream& out) const;
  void printMap(std::ostream& out) const;
  void printTimes(std::ostream& out) const;

  std::vector<ScanReport> reports_;
  std::map<Drop, std::size_t> drops_;
  std::string first_drop_;  // why, in words; empty if none was dropped
};

}  // namespace atom_mapping
