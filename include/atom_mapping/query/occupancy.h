// Occupancy at any point of space, between the atoms (paper III-E).
#pragma once

#include <optional>

#include "atom_mapping/map/atom_map.h"

namespace atom_map {

enum class Occupancy { kUnknown = 0, kFree = 1, kOccupied = 2 };

// Log-odds of occupancy at a point of the map's local frame by Eq. (5); nothing where no atom's centre lies within two
// radii. In signed distance mode the negated signed distance (m) takes the place of the log-odds: only its sign counts.
std::optional<float> interpolate(const AtomMap& map, const Eigen::Vector3f& point);

// Free below, occupied from zero on; unknown without a value.
inline Occupancy classify(std::optional<float> log_odds) {
  if (!log_odds) return Occupancy::kUnknown;
  return *log_odds < 0.0F ? Occupancy::kFree : Occupancy::kOccupied;
}

// What an atom of the map stands for, in either mode.
inline Occupancy classify(const AtomMap& map, ConstAtomRef atom) {
  return classify(map.mode() == Mode::kOccupancy ? atom.value() : -atom.value());
}

// Of the atoms' first values those that classify() calls occupied.
inline AtomBlock::Signs signsOfOccupied(const AtomMap& map) {
  return map.mode() == Mode::kOccupancy ? AtomBlock::kNotNegative : AtomBlock::kNotPositive;
}

// Of log-odds; 0.5 where unknown. Occupancy mode only.
float probability(std::optional<float> log_odds);

}  // namespace atom_map
