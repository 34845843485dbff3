// The implicit surface of a map (paper III-F, IV): where the Gaussian process changes its sign.
#pragma once

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/map/atom_map.h"
#include "atom_mapping/surface/follow_surface.h"
#include "atom_mapping/surface/surface_mesh.h"

namespace atom_map {

// The zero of the Gaussian process on log-odds, or on signed distances, where `parameters.surface` holds it sure enough.
// The same for any number of threads. Throws std::invalid_argument for a resolution that is no length, or when the surface
// passes more than max_cells.
// Choice: how sure, is the field's standard deviation over its slope, that of the surface's place. The paper colours by
// variance and keeps everything; beyond the last atoms that is mostly surface that is not there.
SurfaceMesh extractSurface(const AtomMap& map, const MappingParameters& parameters, const SurfaceRequest& request);

}  // namespace atom_map
