// Finds the cells of a lattice that the implicit surface passes, and evaluates the field there only.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/map/atom_map.h"
#include "atom_mapping/surface/lattice.h"

namespace atom_map {

// Choice: radii to the next atom within which the field is followed. Beyond the 2 of queries, since between atoms that are
// tangent to the surface a cell's corners may lie farther from any, and the surface would have holes.
constexpr float kSurfaceReach = 3.0F;

struct SurfaceRequest {
  Eigen::AlignedBox3d box;  // map frame, m; of the cells' centres. Empty: everywhere
  float resolution = 0.0F;  // m, side of marching cubes' cells; 0: the atoms' radius
  unsigned threads = 1;     // that evaluate the field
  std::size_t max_cells = std::numeric_limits<std::size_t>::max();
  std::function<void(std::size_t)> progress;  // told the points evaluated so far, by the calling thread; may be empty
};

struct SampledSurface {
  Lattice lattice;
  std::vector<float> values;       // one a node, positive in free space; NaN where unknown
  std::vector<LatticeCell> cells;  // with a change of sign
};

// Starts between each occupied atom and the free atom nearest to it and follows the surface from cell to cell. Throws
// std::invalid_argument when it passes more than max_cells.
SampledSurface followSurface(const AtomMap& map, const GaussianProcessParameters& parameters, float spacing,
                             const SurfaceRequest& request);

}  // namespace atom_map
