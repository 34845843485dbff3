#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace atom_map {

// A welded triangle mesh: triangles that meet share their vertices.
struct SurfaceMesh {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();     // map frame, m
  std::vector<Eigen::Vector3f> vertices;                // m, from the origin
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counterclockwise as seen from free space
  std::vector<float> variance;                          // of the field that the surface is the zero of, one a vertex
};

}  // namespace atom_map
