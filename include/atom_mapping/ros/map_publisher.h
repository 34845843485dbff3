#pragma once

#include <ros/ros.h>

#include "atom_mapping/ros/map_snapshot.h"
#include "atom_mapping/ros/node_parameters.h"
#include "atom_mapping/ros/scan_server.h"
#include "atom_mapping/ros/snapshot_publisher.h"

namespace atom_mapping {

// Publishes ~atoms, ~free_atoms and ~atom_cloud.
class MapPublisher {
 public:
  MapPublisher(ros::NodeHandle node, const ScanServer& server, const PublishParameters& parameters);

 private:
  PublishParameters parameters_;
  SnapshotPublisher<MapSnapshot> publisher_;
};

}  // namespace atom_mapping
