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

bool ScanServer::adopt(atom_map::AtomMap map, double radius, std::uint64_t scans) {
  if (!mapper_.adopt(std::move(map), radius, scans)) return false;
  restartTime();
  noteChange();
  return true;
}

atom_map::ScanReport ScanServer::insertScan(const atom_map::LidarScan& scan, const atom_map::Pose& sensor) {
  return mapper_.insertScan(scan, sensor);
}

}  // namespace atom_mapping
