// Random maps for tests of paths: atoms packed as densely as random draws do, some of them occupied.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "atom_mapping/map/atom_map.h"
#include "draw.h"

namespace atom_map {

// In a cube of 2 * half metres. In signed distance mode the atoms tell the distance to the nearest occupied one's rim.
inline AtomMap makePackedMap(std::uint64_t seed, Mode mode, float radius, float half, float occupied_share) {
  Random random(seed);
  AtomMap packed(Mode::kOccupancy, radius);
  for (int i = 0; i < 6000; ++i) {
    const Eigen::Vector3f center = drawWithin(random, half);
    const float value = random.uniform() < occupied_share ? 2.0F : -2.0F;
    if (!packed.atoms().nearest(center, 2.0F * radius)) packed.atoms().insert(center, &value);
  }
  if (mode == Mode::kOccupancy) return packed;
  AtomMap distances(mode, radius);
  const AtomTree& atoms = packed.atoms();
  atoms.forEach([&](ConstAtomRef atom) {
    float nearest = 2.0F;
    atoms.forEachWithin(atom.center(), 2.0F, [&](ConstAtomRef other, float squared) {
      if (other.value() > 0.0F) nearest = std::min(nearest, std::sqrt(squared) - radius);
    });
    const std::array<float, 2> values{atom.value() > 0.0F ? -radius : nearest, 0.01F};
    distances.atoms().insert(atom.center(), values.data());
  });
  return distances;
}

}  // namespace atom_map
