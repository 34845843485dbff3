// Large maps of atoms that do not overlap, in the orders in which robots and files bring them.
#pragma once

#include <functional>

#include "distributions.h"

namespace atom_map {

// Atoms that do not overlap have a cell of one radius (AtomMap), so that their centres lie two cells or more apart.
constexpr float kDiameter = 2.0F * kCell;

// One atom in each of counts.x() * counts.y() * counts.z() places, x slowest, drawn as freely as keeps them apart.
inline Centers looseGrid(const Eigen::Vector3i& counts, std::uint64_t seed, float spacing = 1.4F * kDiameter) {
  Random random(seed);
  Centers centers;
  centers.reserve(static_cast<std::size_t>(counts.prod()));
  for (int x = 0; x < counts.x(); ++x) {
    for (int y = 0; y < counts.y(); ++y) {
      for (int z = 0; z < counts.z(); ++z) {
        const Eigen::Vector3f place = spacing * Eigen::Vector3f(x, y, z);
        centers.emplace_back(place + drawWithin(random, 0.5F * (spacing - kDiameter)));
      }
    }
  }
  return centers;
}

inline Centers shuffled(Centers centers, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = centers.size(); i > 1; --i) std::swap(centers[i - 1], centers[drawIndex(random, i)]);
  return centers;
}

inline std::vector<Distribution> robotOrders() {
  const Centers cube = looseGrid({40, 40, 40}, 1);
  Centers plane = looseGrid({300, 300, 1}, 2);
  for (Eigen::Vector3f& center : plane) center.z() = 1.25F;
  Centers slope = looseGrid({300, 300, 1}, 3);
  for (Eigen::Vector3f& center : slope) center.z() = 0.3F * center.x() - 0.1F * center.y();
  const Centers drive = looseGrid({7200, 5, 3}, 4);  // 10 km
  Centers back = drive;
  std::reverse(back.begin(), back.end());
  Centers diagonal = looseGrid({7200, 1, 1}, 5);
  for (Eigen::Vector3f& center : diagonal) center = Eigen::Vector3f::Constant(center.x() - 5000.0F);
  return {{"straight_drive", drive},
          {"drive_back", back},
          {"drive_far_away", moved(drive, {-1e5F, 1e5F, 0.0F})},
          {"drive_across_the_origin", moved(drive, {-5000.0F, -1.0F, -1.0F})},
          {"diagonal_drive", diagonal},
          {"level_plane", plane},
          {"sloping_plane", slope},
          {"cube", moved(cube, Eigen::Vector3f::Constant(-20.0F * 1.4F * kDiameter))},
          {"cube_sorted_along_x", sortedAlongX(cube)},
          {"cube_shuffled", shuffled(cube, 6)}};
}

}  // namespace atom_map
