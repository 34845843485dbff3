// A picture of a map, drawn without a screen and without an X server.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace atom_map {

struct RenderOptions {
  int width = 1600;  // pixels
  int height = 1000;
  double azimuth = 215.0;       // deg, where the camera stands as seen from the map, counterclockwise from x
  double elevation = 42.0;      // deg, above the horizon
  std::optional<double> cut_z;  // m, atoms above it are left out; no value: what lies at or above a ceiling
};

// Height just beneath the map's ceiling, no value where it has none. `radius` of the atoms in metres.
std::optional<double> findCeiling(const std::vector<Eigen::Vector3f>& centers, float radius);

// Draws occupied atoms as spheres, coloured by height. Throws std::runtime_error when there is nothing to draw, no
// OpenGL (software will do), or the file cannot be written.
void renderAtoms(const std::vector<Eigen::Vector3f>& centers, float radius, const RenderOptions& options,
                 const std::string& png_file);

}  // namespace atom_map
