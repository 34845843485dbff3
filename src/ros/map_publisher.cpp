#include "atom_mapping/ros/map_publisher.h"

#include "atom_mapping/ros/map_messages.h"

namespace atom_mapping {

MapPublisher::MapPublisher(ros::NodeHandle node, const ScanServer& server, const PublishParameters& parameters)
    : parameters_(parameters), publisher_(server, parameters.period, [&server] { return takeSnapshot(server); }) {
  using visualization_msgs::Marker;
  publisher_.advertise<Marker>(node, "atoms", [this](const auto& map) { return toOccupiedMarker(map, parameters_); });
  publisher_.advertise<sensor_msgs::PointCloud2>(node, "atom_cloud", [](const auto& map) { return toAtomCloud(map); });
  if (parameters.free_atoms) {
    publisher_.advertise<Marker>(node, "free_atoms",
                                 [this](const auto& map) { return toFreeMarker(map, parameters_); });
  }
  publisher_.start();
}

}  // namespace atom_mapping
