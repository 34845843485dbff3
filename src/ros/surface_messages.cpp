#include "atom_mapping/ros/surface_messages.h"

#include "atom_mapping/ros/pose_conversion.h"
#include "atom_mapping/surface/sureness.h"

namespace atom_mapping {

shape_msgs::Mesh toMesh(const atom_map::SurfaceMesh& mesh) {
  shape_msgs::Mesh message;
  message.vertices.reserve(mesh.vertices.size());
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    message.vertices.push_back(toPoint(vertex.cast<double>() + mesh.origin));
  }
  message.triangles.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::copy(mesh.triangles[i].begin(), mesh.triangles[i].end(), message.triangles[i].vertex_indices.begin());
  }
  return message;
}

visualization_msgs::Marker toSurfaceMarker(const atom_map::SurfaceMesh& mesh, const std_msgs::Header& header) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = "surface";
  marker.type = visualization_msgs::Marker::TRIANGLE_LIST;
  marker.pose.position = toPoint(mesh.origin);
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color.a = 1.0F;
  if (mesh.triangles.empty()) {  // rviz complains of a list without triangles
    marker.action = visualization_msgs::Marker::DELETE;
    return marker;
  }
  const std::vector<float> brightness = atom_map::brightnessOf(mesh.variance);
  marker.points.reserve(3 * mesh.triangles.size());
  marker.colors.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      marker.points.push_back(toPoint(mesh.vertices[vertex].cast<double>()));
      std_msgs::ColorRGBA color;
      color.r = color.g = color.b = brightness[vertex];
      color.a = 1.0F;
      marker.colors.push_back(color);
    }
  }
  return marker;
}

}  // namespace atom_mapping
