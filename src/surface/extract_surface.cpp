#include "atom_mapping/surface/extract_surface.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "atom_mapping/base/parallel.h"
#include "atom_mapping/query/gaussian_process.h"
#include "atom_mapping/surface/follow_surface.h"
#include "atom_mapping/surface/marching_cubes.h"

namespace atom_map {
namespace {

// Fills in the variance and returns, for each vertex, the standard deviation of its place along the normal (m).
std::vector<float> judgeVertices(const AtomMap& map, const GaussianProcessParameters& parameters, unsigned threads,
                                 SurfaceMesh& mesh) {
  mesh.variance.resize(mesh.vertices.size());
  std::vector<float> deviation(mesh.vertices.size(), std::numeric_limits<float>::infinity());
  parallelFor(mesh.vertices.size(), threads, [&] {
    return [&, process = GaussianProcess(map, parameters)](std::size_t begin, std::size_t end) mutable {
      for (std::size_t i = begin; i < end; ++i) {
        const auto estimate = process.estimate(mesh.vertices[i], kSurfaceReach);
        if (!estimate) continue;
        mesh.variance[i] = estimate->variance;
        // A distance's slope is 1, whatever the regression makes of it at an edge.
        const float slope = map.mode() == Mode::kOccupancy ? estimate->gradient.norm() : 1.0F;
        deviation[i] = std::sqrt(estimate->variance) / slope;
      }
    };
  });
  return deviation;
}

// Keeps the triangles whose vertices all are sure enough, and the vertices that these have.
SurfaceMesh cutUnsure(const SurfaceMesh& mesh, const std::vector<float>& deviation, float limit) {
  constexpr std::uint32_t kUnused = ~0U;
  std::vector<std::uint32_t> ids(mesh.vertices.size(), kUnused);
  SurfaceMesh cut;
  cut.origin = mesh.origin;
  for (auto triangle : mesh.triangles) {
    const auto is_sure = [&](std::uint32_t vertex) { return deviation[vertex] <= limit; };
    if (!is_sure(triangle[0]) || !is_sure(triangle[1]) || !is_sure(triangle[2])) continue;
    for (std::uint32_t& vertex : triangle) {
      std::uint32_t& id = ids[vertex];
      if (id == kUnused) {
        id = static_cast<std::uint32_t>(cut.vertices.size());
        cut.vertices.push_back(mesh.vertices[vertex]);
        cut.variance.push_back(mesh.variance[vertex]);
      }
      vertex = id;
    }
    cut.triangles.push_back(triangle);
  }
  return cut;
}

}  // namespace

float surfaceSpacing(float radius, float resolution) {
  if (resolution == 0.0F) return radius;
  const float finest = radius / 1000.0F;
  if (resolution >= finest && std::isfinite(resolution)) return resolution;
  std::ostringstream text;
  text << "resolution is " << resolution << " m; it must be positive and at least " << finest
       << " m, a thousandth of an atom's radius, or 0 for the radius";
  throw std::invalid_argument(text.str());
}

SurfaceMesh extractSurface(const AtomMap& map, const MappingParameters& parameters, const SurfaceRequest& request) {
  const float spacing = surfaceSpacing(map.radius(), request.resolution);
  const SampledSurface surface = followSurface(map, parameters.gaussian_process, spacing, request);
  SurfaceMesh mesh = marchingCubes(surface.lattice, surface.cells, surface.values);
  mesh.origin = map.origin();
  const std::vector<float> deviation = judgeVertices(map, parameters.gaussian_process, request.threads, mesh);
  const double limit =
      map.mode() == Mode::kOccupancy ? parameters.surface.occupancy_deviation : parameters.surface.distance_deviation;
  return cutUnsure(mesh, deviation, static_cast<float>(limit) * map.radius());
}

}  // namespace atom_map
