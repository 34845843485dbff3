// A picture of a map, drawn without a screen and without an X server.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

namespace atom_map {

struct RenderOptions {
  int width = 1600;  // pixels
  int height = 1000;
  double azimuth = 238.0;   // deg, where the camera stands as seen from the map, counterclockwise from x
  double elevation = 42.0;  // deg, above the horizon
  double cut_z =
      std::numeric_limits<double>::quiet_NaN();  // m, atoms above are left out; NaN: those from the ceiling up
};

// Draws occupied atoms, whose `centers` and `radius` are in metres, as spheres coloured by height. Throws
// std::runtime_error when there is nothing to draw, no OpenGL (software will do), or the file cannot be written.
void renderAtoms(const std::vector<Eigen::Vector3f>& centers, float radius, const RenderOptions& options,
                 const std::string& png_file);

}  // namespace atom_map
