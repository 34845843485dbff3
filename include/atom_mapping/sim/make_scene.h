// The worlds that the map is judged in, by name. Map frame: origin in the middle, z up; the same on every call.
#pragma once

#include <string>
#include <vector>

#include "atom_mapping/sim/scene.h"

namespace atom_map {

// cube, cube_rotated: closed, empty, 2 m a side, centred on the origin, the second turned about a general axis.
// sphere: closed, empty, 1 m of radius.
// hall: indoors, 68 x 65 x 17 m, floor at z = 0.
// campus: outdoors, 168 x 90 x 35 m, on sloping ground.
std::vector<std::string> sceneNames();

// Throws std::invalid_argument, with the names there are, for any other.
Scene makeScene(const std::string& name);

Scene makeHall();
Scene makeCampus();

// Height of the campus' ground, metres.
double campusGroundHeight(double x, double y);

}  // namespace atom_map
