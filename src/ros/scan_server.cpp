#include "atom_mapping/ros/scan_server.h"

namespace atom_mapping {

ScanServer::ScanServer(const atom_map::MappingParameters& parameters)
    : CloudServer(parameters.map_frame, parameters.scan.clear_no_returns), mapper_(parameters) {}

std::size_t ScanServer::clearRegion(const Eigen::AlignedBox3d& box) {
  const std::size_t removed = mapper_.write([&](atom_map::AtomMap& map) { return map.clearRegion(box); });
  noteLimits({});
  noteChange();
  return removed;
}

void ScanServer::reset() {
  mapper_.reset();
  noteLimits({});
  restartTime();
  noteChange();
}

bool ScanServer::adopt(atom_map::AtomMap map, double radius, std::uint64_t scans) {
  if (!mapper_.adopt(std::move(map), radius, scans)) return false;
  noteLimits({});
  restartTime();
  noteChange();
  return true;
}

atom_map::ScanReport ScanServer::insertScan(const atom_map::LidarScan& scan, const atom_map::Pose& sensor) {
  const atom_map::ScanReport report = mapper_.insertScan(scan, sensor);
  noteLimits(report);
  return report;
}

LimitCounts ScanServer::limitCounts() const {
  const std::lock_guard lock(limits_mutex_);
  return limits_;
}

// After each change of the map; of a change that is no scan, with an empty report.
void ScanServer::noteLimits(const atom_map::ScanReport& report) {
  const std::size_t bytes = mapper_.read([](const atom_map::AtomMap& map) { return map.atoms().bytes(); });
  bool has_fallen = false;
  {
    const std::lock_guard lock(limits_mutex_);
    limits_.refused += report.merge.refused;
    limits_.forgotten += report.forgotten;
    limits_.is_full = report.merge.refused > 0;
    has_fallen = fall_.hasFallenTo(bytes);
  }
  if (has_fallen) atom_map::returnFreedMemory();
}

}  // namespace atom_mapping
