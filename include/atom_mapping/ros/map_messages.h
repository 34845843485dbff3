#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/Marker.h>

#include "atom_mapping/ros/map_snapshot.h"
#include "atom_mapping/ros/node_parameters.h"

namespace atom_mapping {

// Atoms that are occupied or, in signed distance mode, nearer to a surface than surface_threshold; in the map frame. At
// most max_markers of them, an even choice. Without any the marker's action is DELETE, as rviz takes an empty list for an
// error.
visualization_msgs::Marker toOccupiedMarker(const MapSnapshot& map, const PublishParameters& parameters);

// All other atoms, as glass.
visualization_msgs::Marker toFreeMarker(const MapSnapshot& map, const PublishParameters& parameters);

// Every atom: x y z log_odds, or x y z signed_distance variance.
sensor_msgs::PointCloud2 toAtomCloud(const MapSnapshot& map);

}  // namespace atom_mapping
