// Atoms from a PLY file, as atom_mapping_offline exports them.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace atom_map {

struct ExportedAtoms {
  float radius = 0.0F;                               // m, from the comment `radius R`
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // m, map frame; near the atoms, so that floats suffice for
  std::vector<Eigen::Vector3f> centers;              // m, from the origin
  std::vector<float> log_odds;                       // of occupancy, one an atom
};

// Reads the vertices' properties x y z log_odds, in this or any other order and beside others, float or double,
// ascii or binary_little_endian. Throws std::runtime_error that says what the file lacks.
ExportedAtoms readAtoms(const std::string& ply_file);

// Centres of the atoms whose log-odds are positive.
std::vector<Eigen::Vector3f> occupiedCenters(const ExportedAtoms& atoms);

}  // namespace atom_map
