// Equations (9) to (11) of the paper, against values computed by hand.
#include <gtest/gtest.h>

#include <array>

#include "atom_mapping/map/merge.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr float kXi = 0.5F;

struct Stored {
  float distance;
  float variance;
};

// What an atom at the origin (r = 0.5 m) stores, of distance 1 m and variance 0.2 m^2, once a candidate was merged that lies
// `offset` from it.
Stored mergedWith(const DistanceCandidate& candidate) {
  AtomMap map(Mode::kSignedDistance, 0.5);
  const std::array<float, 2> values{1.0F, 0.2F};
  map.atoms().insert(Vector3f::Zero(), values.data());
  SignedDistanceParameters parameters;
  parameters.xi = kXi;
  DistanceMerge merge(map, parameters);
  merge.add(&candidate, &candidate + 1);
  EXPECT_EQ(map.atoms().size(), 1U);
  EXPECT_EQ(merge.report().updates, 1U);
  Stored stored{};
  map.atoms().forEach([&](ConstAtomRef atom) { stored = {atom.value(0), atom.value(1)}; });
  return stored;
}

// d = r = 0.5: w = 5 / 16 (Eq. 4); sigma^2(b) = 0.36 / 0.8125 = 0.443077 (Eq. 9); gain = 0.2 / 0.643077 = 0.311005.
TEST(Equations9To11, OfACandidateBesideTheAtomByHand) {
  const Stored stored = mergedWith({{0.5F, 0.0F, 0.0F}, 0.6F, Vector3f::UnitZ()});
  EXPECT_NEAR(stored.distance, 1.0 + 0.311005 * (0.6 - 1.0), 1e-5);  // Eq. (10)
  EXPECT_NEAR(stored.variance, 0.2 * (1.0 - 0.311005), 1e-5);        // Eq. (11)
}

// The same, half a metre farther from the surface than the atom: of the atom it tells 0.5 m less.
TEST(Equations9To11, TellOfTheAtomsOwnPlaceAlongTheNormal) {
  const Stored stored = mergedWith({{0.0F, 0.0F, 0.5F}, 0.6F, Vector3f::UnitZ()});
  EXPECT_NEAR(stored.distance, 1.0 + 0.311005 * (0.1 - 1.0), 1e-5);
  EXPECT_NEAR(stored.variance, 0.2 * (1.0 - 0.311005), 1e-5);
}

TEST(Equations9To11, ANewAtomHasTheVarianceOfFullOverlap) {
  AtomMap map(Mode::kSignedDistance, 0.5);
  DistanceMerge merge(map, {kXi});
  const DistanceCandidate candidate{Vector3f::Zero(), -0.6F, Vector3f::UnitZ()};
  merge.add(&candidate, &candidate + 1);
  map.atoms().forEach([](ConstAtomRef atom) {
    EXPECT_FLOAT_EQ(atom.value(0), -0.6F);
    EXPECT_NEAR(atom.value(1), 0.36 / 1.5, 1e-6);
  });
}

// An atom of another map, d = r: variance 0.1 / w = 0.32; gain = 0.2 / 0.52.
TEST(Equations9To11, AnAtomOfAnotherMapCountsByItsOwnVariance) {
  AtomMap map(Mode::kSignedDistance, 0.5);
  const std::array<float, 2> values{1.0F, 0.2F};
  map.atoms().insert(Vector3f::Zero(), values.data());
  DistanceMerge merge(map, {kXi});
  const ToldDistance told{{{0.5F, 0.0F, 0.0F}, 0.6F, Vector3f::UnitZ()}, 0.1F};
  merge.add(&told, &told + 1);
  map.atoms().forEach([](ConstAtomRef atom) {
    EXPECT_NEAR(atom.value(0), 1.0 + 0.2 / 0.52 * (0.6 - 1.0), 1e-5);
    EXPECT_NEAR(atom.value(1), 0.2 * (1.0 - 0.2 / 0.52), 1e-5);
  });
}

}  // namespace
}  // namespace atom_map
