// Names, ranges and units of the parameters: what reads, checks, prints or documents them walks over these.
#pragma once

#include <cstdint>
#include <limits>

#include "atom_mapping/base/parameters.h"

namespace atom_map {

// Permitted values: low to high, both included unless open.
struct Range {
  double low;
  double high;
  bool open = false;     // low itself is not permitted
  bool or_zero = false;  // 0 is permitted too

  bool contains(double value) const {
    return (or_zero && value == 0.0) || ((open ? value > low : value >= low) && value <= high);
  }
};

constexpr Range zeroOr(double low, double high) {
  return {low, high, false, true};
}

// Calls visit(name, field, range) for each number, visit(name, field) for each flag, text, mode and policy, with names such as
// "scan/max_range". `Parameters` is MappingParameters or const MappingParameters.
template <class Parameters, class Visit>
void forEachParameter(Parameters& p, Visit&& visit) {
  constexpr double kMost = 1e6;  // of what has no bound of its own: floats bear its square
  visit("map_frame", p.map_frame);
  visit("mode", p.mode);
  visit("radius", p.radius, Range{0.01, 100.0});
  visit("seed", p.seed, Range{0.0, std::numeric_limits<std::uint32_t>::max()});

  visit("scan/min_range", p.scan.min_range, Range{0.0, 1000.0});
  visit("scan/max_range", p.scan.max_range, Range{0.0, 1000.0, true});
  visit("scan/thinning", p.scan.thinning, zeroOr(0.01, 10.0));
  visit("scan/horizontal_resolution", p.scan.horizontal_resolution, Range{0.05, 45.0});
  visit("scan/vertical_resolution", p.scan.vertical_resolution, Range{0.05, 45.0});
  visit("scan/range_noise", p.scan.range_noise, Range{0.0, 1.0});
  visit("scan/normal_support", p.scan.normal_support, Range{0.0, 10.0, true});
  visit("scan/shared_normals", p.scan.shared_normals, zeroOr(0.01, 10.0));
  visit("scan/thin_width", p.scan.thin_width, Range{0.0, 10.0});
  visit("scan/clear_no_returns", p.scan.clear_no_returns);

  visit("rays/lambda", p.rays.lambda, Range{0.0, kMost});
  visit("rays/max_incidence", p.rays.max_incidence, Range{0.0, 89.0});
  visit("rays/normal_distance", p.rays.normal_distance, Range{0.0, 100.0});
  visit("rays/candidate_cell", p.rays.candidate_cell, zeroOr(0.01, 10.0));

  visit("occupancy/hit_probability", p.occupancy.hit_probability, Range{0.5, 0.999, true});
  visit("occupancy/miss_probability", p.occupancy.miss_probability, Range{0.001, 0.499});
  visit("occupancy/thin_weight", p.occupancy.thin_weight, Range{0.0, 100.0, true});
  visit("occupancy/hold_reach", p.occupancy.hold_reach, Range{0.0, 2.0});
  visit("occupancy/max_log_odds", p.occupancy.max_log_odds, Range{0.1, 100.0});

  visit("signed_distance/xi", p.signed_distance.xi, Range{0.0, kMost, true});

  visit("gaussian_process/answers_occupancy", p.gaussian_process.answers_occupancy);
  visit("gaussian_process/neighbors", p.gaussian_process.neighbors, Range{1.0, 64.0});
  visit("gaussian_process/alpha", p.gaussian_process.alpha, Range{0.0, 100.0, true});
  visit("gaussian_process/noise_variance", p.gaussian_process.noise_variance, Range{1e-6, 1e6});
  visit("gaussian_process/distance_alpha", p.gaussian_process.distance_alpha, Range{0.0, 100.0, true});
  visit("gaussian_process/distance_noise", p.gaussian_process.distance_noise, Range{1e-6, 1e6});
  visit("gaussian_process/atom_variance_share", p.gaussian_process.atom_variance_share, Range{0.0, 1e6});

  visit("surface/occupancy_deviation", p.surface.occupancy_deviation, Range{0.0, kMost, true});
  visit("surface/distance_deviation", p.surface.distance_deviation, Range{0.0, kMost, true});

  visit("planning/robot_radius", p.planning.robot_radius, Range{0.0, 100.0});
  visit("planning/surface_distance", p.planning.surface_distance, Range{0.0, 100.0});
  visit("planning/surface_weight", p.planning.surface_weight, Range{0.0, 1e6});
  visit("planning/timeout", p.planning.timeout, Range{0.0, 3600.0, true});
  visit("planning/shortcut", p.planning.shortcut);

  visit("limits/max_atoms", p.limits.max_atoms, Range{0.0, std::numeric_limits<std::uint32_t>::max()});
  visit("limits/max_megabytes", p.limits.max_megabytes, Range{0.0, 1e6});
  visit("limits/policy", p.limits.policy);
  visit("limits/window", p.limits.window, Range{0.0, kMost});
}

}  // namespace atom_map
