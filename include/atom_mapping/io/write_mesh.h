#pragma once

#include <string>

#include "atom_mapping/surface/surface_mesh.h"

namespace atom_map {

// Writes a mesh as .ply (binary little endian), in the map frame and metres: vertices with x y z variance and a colour,
// dark where they are sure, and triangles. The file appears, or takes the place of an old one, when it is whole. Throws
// std::invalid_argument for any other extension, std::runtime_error with file and reason when it cannot be written.
void writeMesh(const SurfaceMesh& mesh, const std::string& file);

// Throws what writeMesh would if the extension is another or the folder is not there or takes no files: to be asked before
// hours of mapping.
void checkMeshFile(const std::string& file);

}  // namespace atom_map
