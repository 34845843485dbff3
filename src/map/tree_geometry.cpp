#include "atom_mapping/map/tree_geometry.h"

#include <algorithm>
#include <cmath>

namespace atom_map {

CutWay::CutWay(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius) {
  constexpr float kLeastWay = 1e-30F;  // m; planes beside a way that goes none along an axis are crossed far off
  for (int i = 0; i < 3; ++i) {
    const float way = to[i] - from[i];
    const float rounding =
        4.0F * kTreeRounding * (std::max(std::abs(from[i]), std::abs(to[i])) + radius + std::abs(way));
    const float shares_per_metre = 1.0F / std::copysign(std::max(std::abs(way), kLeastWay), way);
    axes[static_cast<std::size_t>(i)] = {from[i], shares_per_metre, (radius + rounding) * std::abs(shares_per_metre)};
  }
}

}  // namespace atom_map
