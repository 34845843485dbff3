#include "atom_mapping/ros/baseline_server.h"

namespace atom_mapping {

BaselineServer::BaselineServer(const BaselineParameters& parameters)
    : CloudServer(parameters.mapping.map_frame, parameters.mapping.scan.clear_no_returns),
      mapper_(parameters.mapping, parameters.octomap) {}

void BaselineServer::reset() {
  mapper_.reset();
  restartTime();
  noteChange();
}

// Of a report's units, a leaf takes the place of an atom; none of its seconds goes into counting them.
atom_map::ScanReport BaselineServer::insertScan(const atom_map::LidarScan& scan, const atom_map::Pose& sensor) {
  atom_map::ScanReport report = mapper_.insertScan(scan, sensor);
  mapper_.read([&](const atom_map::OctomapBaseline& map) {
    report.atoms = map.tree().getNumLeafNodes();
    report.map_bytes = map.bytes();
  });
  return report;
}

}  // namespace atom_mapping
