#pragma once

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/ros/baseline_parameters.h"
#include "atom_mapping/ros/node_parameters.h"
#include "atom_mapping/ros/parameter_values.h"

namespace atom_mapping {

struct Parameters {
  atom_map::MappingParameters mapping;
  NodeParameters node;
};

// The defaults, save where there is a value. Throws std::invalid_argument that names, a line each, every value of an
// unknown name, of the wrong type or out of its range. A whole number serves where any number does.
Parameters readParameters(const ParameterValues& values);

// The same for octomap_baseline_node.
BaselineParameters readBaselineParameters(const ParameterValues& values);

}  // namespace atom_mapping
