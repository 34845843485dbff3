// Candidates of surface points without the chance of interleaving.
#pragma once

#include <limits>
#include <vector>

#include "atom_mapping/scan/rays.h"

namespace atom_map {

constexpr float kRadius = 0.3F;
constexpr float kWide = std::numeric_limits<float>::infinity();
constexpr float kRounding = 1e-4F;

// No candidate is dropped by interleaving.
inline MappingParameters keepingAll() {
  MappingParameters parameters;
  parameters.radius = kRadius;
  parameters.rays.lambda = 1e12;
  return parameters;
}

inline Candidates trace(const std::vector<SurfacePoint>& surface, const Eigen::Vector3f& sensor,
                        const std::vector<Eigen::Vector3f>& no_returns = {}) {
  Random random(1);
  return traceRays(surface, no_returns, sensor, keepingAll(), random);
}

}  // namespace atom_map
