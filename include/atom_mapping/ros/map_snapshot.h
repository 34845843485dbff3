#pragma once

#include <ros/time.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "atom_mapping/ros/scan_server.h"

namespace atom_mapping {

// A copy of the map, to be turned into messages while mapping goes on.
struct MapSnapshot {
  struct Atom {
    Eigen::Vector3f center;       // from `origin`, parallel to the map frame
    std::array<float, 2> values;  // as the map's; the second is 0 in occupancy mode
  };

  std::string frame;
  ros::Time stamp;  // of the newest scan in it
  std::uint64_t revision;
  atom_map::Mode mode;
  float radius;
  Eigen::Vector3d origin;  // map frame
  std::vector<Atom> atoms;
};

// Holds scans up for as long as copying takes: 10 to 30 ms for a million atoms.
MapSnapshot takeSnapshot(const ScanServer& server);

// A map of the same atoms, for what asks maps.
atom_map::AtomMap toAtomMap(const MapSnapshot& snapshot);

}  // namespace atom_mapping
