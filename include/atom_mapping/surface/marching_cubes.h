#pragma once

#include <vector>

#include "atom_mapping/surface/lattice.h"
#include "atom_mapping/surface/surface_mesh.h"

namespace atom_map {

// The zero of a field within cells of the lattice, whose `values` (one a node) are known at the cells' corners. Triangles
// are counterclockwise as seen from where the field is positive. Leaves origin and variance empty.
SurfaceMesh marchingCubes(const Lattice& lattice, const std::vector<LatticeCell>& cells,
                          const std::vector<float>& values);

}  // namespace atom_map
