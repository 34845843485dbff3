#include "atom_mapping/query/occupancy.h"

#include <cmath>

#include "atom_mapping/map/overlap.h"

namespace atom_map {

std::optional<float> interpolate(const AtomMap& map, const Eigen::Vector3f& point) {
  const float diameter = 2.0F * map.radius();
  const float per_diameter = 1.0F / diameter;
  const float sign = map.mode() == Mode::kOccupancy ? 1.0F : -1.0F;
  float weights = 0.0F;
  float sum = 0.0F;
  map.atoms().forEachWithin(point, diameter, [&](ConstAtomRef atom, float squared_distance) {
    const float overlap = overlapFraction(std::sqrt(squared_distance) * per_diameter);
    weights += overlap;
    sum += overlap * sign * atom.value();
  });
  if (weights <= 0.0F) return std::nullopt;
  return sum / weights;  // Eq. (5)
}

float probability(std::optional<float> log_odds) {
  return log_odds ? 1.0F / (1.0F + std::exp(-*log_odds)) : 0.5F;
}

}  // namespace atom_map
