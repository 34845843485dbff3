#pragma once

#include <cstdint>
#include <mutex>
#include <utility>

#include "atom_mapping/base/keep_memory.h"
#include "atom_mapping/map/mapper.h"
#include "atom_mapping/ros/cloud_server.h"

namespace atom_mapping {

// What limits/ did, in atoms, since the node started.
struct LimitCounts {
  std::uint64_t refused = 0;
  std::uint64_t forgotten = 0;
  bool is_full = false;  // the last scan found no room
};

// Clouds and transforms in, atom map out: what the node and the offline tool share.
class ScanServer : public CloudServer {
 public:
  // Throws std::invalid_argument that names every parameter out of its range.
  explicit ScanServer(const atom_map::MappingParameters& parameters);

  // As AtomMap::clearRegion and Mapper::reset. Reset also restarts time; counts go on.
  std::size_t clearRegion(const Eigen::AlignedBox3d& box);
  void reset();
  // As Mapper::adopt. Also restarts time.
  bool adopt(atom_map::AtomMap map, double radius, std::uint64_t scans);

  // As Mapper::read.
  template <class F>
  auto read(F&& f) const {
    return mapper_.read(std::forward<F>(f));
  }

  LimitCounts limitCounts() const;

  const atom_map::Mapper& mapper() const { return mapper_; }
  // As Mapper::parameters: mode and radius change when an empty map takes over those of another.
  atom_map::MappingParameters parameters() const { return mapper_.parameters(); }

 private:
  atom_map::ScanReport insertScan(const atom_map::LidarScan& scan, const atom_map::Pose& sensor) override;

  void noteLimits(const atom_map::ScanReport& report);

  atom_map::Mapper mapper_;
  mutable std::mutex limits_mutex_;  // of what follows
  LimitCounts limits_;
  atom_map::FallWatch fall_;
};

}  // namespace atom_mapping
