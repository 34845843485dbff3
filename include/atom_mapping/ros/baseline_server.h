#pragma once

#include <utility>

#include "atom_mapping/baseline/octomap_mapper.h"
#include "atom_mapping/ros/baseline_parameters.h"
#include "atom_mapping/ros/cloud_server.h"

namespace atom_mapping {

// Clouds and transforms in, OctoMap out.
class BaselineServer : public CloudServer {
 public:
  // Throws std::invalid_argument that names every parameter out of its range.
  explicit BaselineServer(const BaselineParameters& parameters);

  // Empties the map and restarts time; counts go on.
  void reset();

  // As OctomapMapper::read.
  template <class F>
  auto read(F&& f) const {
    return mapper_.read(std::forward<F>(f));
  }

  const atom_map::MappingParameters& parameters() const { return mapper_.parameters(); }

 private:
  atom_map::ScanReport insertScan(const atom_map::LidarScan& scan, const atom_map::Pose& sensor) override;

  atom_map::OctomapMapper mapper_;
};

}  // namespace atom_mapping
