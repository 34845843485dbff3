#pragma once

#include <octomap/OcTree.h>

#include <string>

namespace atom_map {

// Throws std::invalid_argument unless the name ends in .ot or .bt.
void checkOctomapFile(const std::string& file);

// Writes a file for octovis and octomap_server: .ot with every voxel's log-odds, or .bt with free and occupied alone.
// The tree comes by value, since OctoMap updates inner nodes and, for .bt, joins equal ones first. Throws
// std::invalid_argument on another name, std::runtime_error with the system's reason.
void saveOctomap(octomap::OcTree tree, const std::string& file);

}  // namespace atom_map
