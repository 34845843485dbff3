#pragma once

#include <Eigen/Core>

namespace atom_map {

// A plane that returns of a scan lie on and that several fits agreed on; told to the next scan. In the map's local frame.
struct KnownPlane {
  Eigen::Vector3f place;   // m, of one of the returns: in whose cell the plane is known
  Eigen::Vector3f normal;  // unit, to the side that was seen
  float level;             // m, along the normal from the origin
  float fits;              // how many agree
};

}  // namespace atom_map
