// What a map says of points between its atoms (paper III-E, Eq. 5), against a walk over all atoms.
#include "atom_mapping/query/occupancy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "atom_list.h"
#include "draw.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr float kRadius = 0.3F;

// Eq. (4) and (5) in double precision; `weights` tells how much the atoms near the point weigh together.
double interpolateByHand(const std::vector<PlainAtom>& atoms, const Vector3f& point, double& weights) {
  const auto r = static_cast<double>(kRadius);
  double sum = 0.0;
  weights = 0.0;
  for (const PlainAtom& atom : atoms) {
    const double d = distance(atom.center, point);
    if (d >= 2.0 * r) continue;
    const double w = 1.0 - d / (4.0 * r * r * r) * (3.0 * r * r - d * d / 4.0);
    weights += w;
    sum += w * static_cast<double>(atom.values[0]);
  }
  return sum / weights;
}

std::vector<PlainAtom> drawAtoms(Random& random, int count) {
  std::vector<PlainAtom> atoms;
  for (int i = 0; i < count; ++i) {
    const Vector3f center = drawWithin(random, 2.0F);
    atoms.push_back({center, {draw(random, -3.0F, 3.0F), draw(random, 0.1F, 1.0F)}});
  }
  return atoms;
}

AtomMap makeMap(const std::vector<PlainAtom>& atoms, Mode mode) {
  AtomMap map(mode, static_cast<double>(kRadius));
  for (const PlainAtom& atom : atoms) map.atoms().insert(atom.center, atom.values.data());
  return map;
}

TEST(Occupancy, InterpolationIsEquation5OverAllAtoms) {
  Random random(1);
  for (const int count : {0, 1, 2, 30, 300}) {
    const std::vector<PlainAtom> atoms = drawAtoms(random, count);
    const AtomMap map = makeMap(atoms, Mode::kOccupancy);
    for (int i = 0; i < 1000; ++i) {
      const Vector3f point = drawWithin(random, 2.5F);
      double weights = 0.0;
      const double expected = interpolateByHand(atoms, point, weights);
      const auto found = interpolate(map, point);
      if (weights > 0.0 && weights < 1e-3) continue;  // an atom just two radii away: rounding decides
      ASSERT_EQ(found.has_value(), weights > 0.0);
      ASSERT_NEAR(found.value_or(0.0F), weights > 0.0 ? expected : 0.0, 1e-3);
    }
  }
}

TEST(Occupancy, InterpolationLiesBetweenTheAtomsThatItIsMadeOf) {
  Random random(2);
  const std::vector<PlainAtom> atoms = drawAtoms(random, 100);
  const AtomMap map = makeMap(atoms, Mode::kOccupancy);
  for (int i = 0; i < 2000; ++i) {
    const Vector3f point = drawWithin(random, 2.0F);
    const auto found = interpolate(map, point);
    if (!found) continue;
    float least = 1e9F;
    float greatest = -1e9F;
    map.atoms().forEachWithin(point, 2.0F * kRadius, [&](ConstAtomRef atom, float) {
      least = std::min(least, atom.value());
      greatest = std::max(greatest, atom.value());
    });
    ASSERT_GE(*found, least - 1e-4F);
    ASSERT_LE(*found, greatest + 1e-4F);
  }
}

TEST(Occupancy, InSignedDistanceModeTheNegatedDistanceTakesTheLogOddsPlace) {
  Random random(3);
  const std::vector<PlainAtom> atoms = drawAtoms(random, 100);
  const AtomMap distances = makeMap(atoms, Mode::kSignedDistance);
  const AtomMap log_odds = makeMap(atoms, Mode::kOccupancy);
  for (int i = 0; i < 1000; ++i) {
    const Vector3f point = drawWithin(random, 2.0F);
    const auto expected = interpolate(log_odds, point);
    ASSERT_EQ(interpolate(distances, point), expected ? std::make_optional(-*expected) : std::nullopt);
  }
}

TEST(Occupancy, SignTellsFreeFromOccupiedAndNothingIsUnknown) {
  EXPECT_EQ(classify(-0.001F), Occupancy::kFree);
  EXPECT_EQ(classify(-9.0F), Occupancy::kFree);
  EXPECT_EQ(classify(0.001F), Occupancy::kOccupied);
  EXPECT_EQ(classify(0.0F), Occupancy::kOccupied) << "in doubt, occupied";
  EXPECT_EQ(classify(std::nullopt), Occupancy::kUnknown);
}

TEST(Occupancy, ProbabilityIsTheLogisticFunctionAndOneHalfWhereUnknown) {
  EXPECT_FLOAT_EQ(probability(std::nullopt), 0.5F);
  EXPECT_FLOAT_EQ(probability(0.0F), 0.5F);
  for (const float p : {0.01F, 0.4F, 0.7F, 0.999F}) {
    EXPECT_NEAR(probability(std::log(p / (1.0F - p))), p, 1e-6F);
  }
}

}  // namespace
}  // namespace atom_map
