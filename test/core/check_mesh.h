// What must hold of any mesh, and how far it lies from the truth.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "atom_mapping/sim/scene.h"
#include "atom_mapping/surface/surface_mesh.h"

namespace atom_map {

struct Topology {
  std::size_t open_edges = 0;  // with a triangle on one side only
  bool manifold = true;        // no directed edge twice
  long euler = 0;              // vertices - edges + triangles
};

inline Topology topologyOf(const SurfaceMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::set<std::uint32_t> vertices;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{triangle[i], triangle[(i + 1) % 3]}];
    vertices.insert(triangle.begin(), triangle.end());
  }
  Topology topology;
  std::size_t shared = 0;
  for (const auto& [edge, count] : edges) {
    if (count > 1) topology.manifold = false;
    (edges.count({edge.second, edge.first}) > 0 ? shared : topology.open_edges) += 1;
  }
  topology.euler = static_cast<long>(vertices.size()) - static_cast<long>(shared / 2 + topology.open_edges) +
                   static_cast<long>(mesh.triangles.size());
  return topology;
}

struct SurfaceError {
  double rms = 0.0;            // m
  double percentile_95 = 0.0;  // m
  double facing_free = 0.0;    // share of the triangles that look into free space
};

inline SurfaceError errorOf(const SurfaceMesh& mesh, const Scene& scene) {
  std::vector<double> errors;
  double sum = 0.0;
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    errors.push_back(std::abs(scene.signedDistance(vertex.cast<double>() + mesh.origin)));
    sum += errors.back() * errors.back();
  }
  if (errors.empty()) return {};
  const auto percentile = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() * 95 / 100);
  std::nth_element(errors.begin(), percentile, errors.end());
  std::size_t facing = 0;
  for (const auto& triangle : mesh.triangles) {
    const auto corner = [&](std::size_t i) { return mesh.vertices[triangle[i]].cast<double>().eval(); };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    const Eigen::Vector3d middle = (corner(0) + corner(1) + corner(2)) / 3.0 + mesh.origin;
    facing += scene.signedDistance(middle + 0.02 * normal) > scene.signedDistance(middle - 0.02 * normal) ? 1 : 0;
  }
  return {std::sqrt(sum / static_cast<double>(errors.size())), *percentile,
          static_cast<double>(facing) / static_cast<double>(std::max<std::size_t>(mesh.triangles.size(), 1))};
}

}  // namespace atom_map
