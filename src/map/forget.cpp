#include "atom_mapping/map/forget.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace atom_map {
namespace {

// As whole numbers, floats that are not negative have the same order.
std::uint32_t bitsOf(float number) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

// Which digit the number of this rank begins with, and its rank among those.
struct Digit {
  std::uint32_t value;
  std::size_t rank;
};
Digit digitAt(const std::vector<std::size_t>& counts, std::size_t rank) {
  std::uint32_t value = 0;
  while (rank >= counts[value]) rank -= counts[value++];
  return {value, rank};
}

// At most, since the atoms' own bytes are not all that a map takes.
std::size_t countOfKept(const AtomTree& tree, const MapLimit& limit) {
  const auto size = static_cast<double>(tree.size());
  const double for_atoms = kKeptShare * static_cast<double>(limit.atoms);
  const double for_bytes = kKeptShare * size * (static_cast<double>(limit.bytes) / static_cast<double>(tree.bytes()));
  return static_cast<std::size_t>(std::min({for_atoms, for_bytes, size - 1.0}));
}

}  // namespace

KeptBall windowAround(const AtomMap& map, double window, const Eigen::Vector3d& sensor) {
  const double slack = kWindowSlack * window;
  const double cell = slack / std::sqrt(3.0);
  const Eigen::Vector3d center = cell * ((sensor / cell).array().floor() + 0.5);
  return {map.toLocal(center), static_cast<float>(window + 0.5 * slack)};
}

std::optional<KeptBall> ballOfNearest(const AtomMap& map, const MapLimit& limit, const Eigen::Vector3d& sensor) {
  const AtomTree& atoms = map.atoms();
  if (limit.holds(atoms)) return std::nullopt;
  const Eigen::Vector3f center = map.toLocal(sensor);
  return KeptBall{center, radiusOfNearest(atoms, center, countOfKept(atoms, limit))};
}

// Again where nodes' arrays, which shrink by halves, are left too large.
std::size_t forgetFarthest(AtomMap& map, const MapLimit& limit, const Eigen::Vector3d& place) {
  std::size_t forgotten = 0;
  while (const auto ball = ballOfNearest(map, limit, place)) {
    forgotten += map.atoms().removeBeyond(ball->center, ball->radius);
  }
  return forgotten;
}

// Finds the squared distance of that rank by its upper and then its lower 16 bits.
float radiusOfNearest(const AtomTree& tree, const Eigen::Vector3f& p, std::size_t count) {
  assert(count < tree.size());
  constexpr std::uint32_t kHalf = 16;
  constexpr std::uint32_t kLowBits = (1U << kHalf) - 1;
  std::vector<std::size_t> counts(1U << kHalf);
  tree.forEach([&](ConstAtomRef atom) { ++counts[bitsOf(atom.block->squaredDistance(atom.index, p)) >> kHalf]; });
  const Digit upper = digitAt(counts, count);
  std::fill(counts.begin(), counts.end(), 0);
  tree.forEach([&](ConstAtomRef atom) {
    const std::uint32_t bits = bitsOf(atom.block->squaredDistance(atom.index, p));
    if (bits >> kHalf == upper.value) ++counts[bits & kLowBits];
  });
  const std::uint32_t bits = upper.value << kHalf | digitAt(counts, upper.rank).value;
  float squared = 0.0F;
  std::memcpy(&squared, &bits, sizeof squared);
  float radius = std::sqrt(squared);
  while (radius * radius > squared) radius = std::nextafter(radius, 0.0F);
  return radius;
}

}  // namespace atom_map
