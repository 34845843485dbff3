#pragma once

#include <shape_msgs/Mesh.h>
#include <visualization_msgs/Marker.h>

#include "atom_mapping/surface/surface_mesh.h"

namespace atom_mapping {

// In the map frame, metres.
shape_msgs::Mesh toMesh(const atom_map::SurfaceMesh& mesh);

// A TRIANGLE_LIST, dark where the surface is sure. `header`: frame and stamp of the map.
visualization_msgs::Marker toSurfaceMarker(const atom_map::SurfaceMesh& mesh, const std_msgs::Header& header);

}  // namespace atom_mapping
