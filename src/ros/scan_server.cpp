#include "atom_mapping/ros/scan_server.h"

namespace atom_mapping {

ScanServer::ScanServer(const atom_map::MappingParameters& parameters)
    : CloudServer(parameters.map_frame, parameters.scan.clear_no_returns), mapper_(parameters) {}

std::size_t ScanServer::clearRegion(const Eigen::AlignedBox3d& box) {
  const std::size_t removed = mapper_.write([&](atom_map::AtomMap& map) { return map.clearRegion(box); });
  noteChange();
  return removed;
}

void ScanServer::reset() {
  mapper_.reset();
  restartTime();
  noteChange();
}

void ScanServer::replace(atom_map::AtomMap map, std::uint64_t scans) {
  mapper_.replace(std::move(map), scans);
  restartTime();
  noteChange();
}

atom_map::ScanReport ScanServer::insertScan(const atom_map::LidarScan& scan, const atom_map::Pose& sensor) {
  return mapper_.insertScan(scan, sensor);
}

}  // namespace atom_mapping
