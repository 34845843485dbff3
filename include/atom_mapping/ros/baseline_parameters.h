// Parameters of octomap_baseline_node: those of atom_mapping_node that mean something to it, under the same names, and
// OctoMap's own. config/octomap_baseline.yaml repeats their defaults.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "atom_mapping/ros/node_parameters.h"

namespace atom_mapping {

struct BaselineParameters {
  atom_map::MappingParameters mapping;
  atom_map::OctomapParameters octomap;
  NodeParameters node;
};

inline bool concernsBaseline(std::string_view name) {
  constexpr std::array<std::string_view, 11> kNames{"map_frame",
                                                    "radius",
                                                    "seed",
                                                    "scan/min_range",
                                                    "scan/max_range",
                                                    "scan/thinning",
                                                    "scan/clear_no_returns",
                                                    "input/transform_timeout",
                                                    "input/queue_size",
                                                    "publish/period",
                                                    "services/max_points"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

// As atom_map::forEachParameter.
template <class Parameters, class Visit>
void forEachBaselineParameter(Parameters& p, Visit&& visit) {
  const auto visit_shared = [&](const char* name, auto& field, const auto&... range) {
    if (concernsBaseline(name)) visit(name, field, range...);
  };
  atom_map::forEachParameter(p.mapping, visit_shared);
  forEachNodeParameter(p.node, visit_shared);
  visit("resolution", p.octomap.resolution, atom_map::Range{0.0, 100.0});
  visit("prune", p.octomap.prune);
}

}  // namespace atom_mapping
