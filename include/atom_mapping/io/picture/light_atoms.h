// How much light falls on each atom of a picture.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace atom_map {

// For each atom the light of the open sky and of a low sun (unit direction towards it), 0 in the dark, 1 in the open.
// Centres must be finite.
std::vector<float> lightAtoms(const std::vector<Eigen::Vector3f>& centers, float radius, const Eigen::Vector3f& sun);

}  // namespace atom_map
