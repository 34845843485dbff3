// The implicit surface of a map (paper III-F, IV): where the Gaussian process changes its sign.
#pragma once

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/map/atom_map.h"
#include "atom_mapping/surface/follow_surface.h"
#include "atom_mapping/surface/surface_mesh.h"

namespace atom_map {

// The zero of the Gaussian process on log-odds, or on signed distances, where `parameters.surface` holds it sure enough.
// The same for any number of threads. Throws std::invalid_argument as surfaceSpacing does, or when the surface passes more
// than max_cells.
// Choice: how sure, is the field's standard deviation over its slope, that of the surface's place. The paper colours by
// variance and keeps everything; beyond the last atoms that is mostly surface that is not there.
SurfaceMesh extractSurface(const AtomMap& map, const MappingParameters& parameters, const SurfaceRequest& request);

// Side of marching cubes' cells (m): `resolution`, or the radius where that is 0. Throws std::invalid_argument for what is no
// length, or less than a thousandth of the radius.
float surfaceSpacing(float radius, float resolution);

}  // namespace atom_map
