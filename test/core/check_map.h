// What holds of every map, whatever was mapped.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "atom_mapping/map/atom_map.h"

namespace atom_map {

// Every atom's centre and values, bit by bit, in the tree's order.
inline std::vector<float> bytesOf(const AtomMap& map) {
  std::vector<float> bytes;
  map.atoms().forEach([&](ConstAtomRef atom) {
    const Eigen::Vector3f center = atom.center();
    bytes.insert(bytes.end(), {center.x(), center.y(), center.z(), atom.value()});
    if (map.mode() == Mode::kSignedDistance) bytes.push_back(atom.value(1));
  });
  return bytes;
}

inline void expectNoOverlap(const AtomMap& map) {
  const float reach = 2.0F * map.radius() * AtomMap::kOverlapTolerance * (1.0F - 1e-5F);  // less the rounding
  std::size_t overlaps = 0;
  map.atoms().forEach([&](ConstAtomRef atom) {
    map.atoms().forEachWithin(atom.center(), reach, [&](ConstAtomRef, float) { ++overlaps; });
  });
  EXPECT_EQ(overlaps, map.atoms().size()) << "each atom should find itself alone";
}

inline void expectWithinClamps(const AtomMap& map, double max_log_odds) {
  float greatest = 0.0F;
  map.atoms().forEach([&](ConstAtomRef atom) {
    ASSERT_TRUE(std::isfinite(atom.value()) && atom.center().allFinite());
    greatest = std::max(greatest, std::abs(atom.value()));
  });
  EXPECT_LE(greatest, static_cast<float>(max_log_odds));
}

}  // namespace atom_map
