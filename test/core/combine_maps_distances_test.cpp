// Signed distances of two maps become their mean by inverse variance, each told where the other's atom lies.
#include <array>
#include <cmath>
#include <utility>

#include "atom_mapping/query/combine_maps.h"
#include "combine_maps_seeds.h"
#include "list_merge.h"
#include "map_file_folder.h"

namespace atom_map {
namespace {

AtomMap oneAtom(const Eigen::Vector3f& center, float distance, float variance) {
  AtomMap map(Mode::kSignedDistance, double{kRadius});
  const std::array<float, 2> values{distance, variance};
  map.atoms().insert(center, values.data());
  return map;
}

TEST_P(CombineMaps, DistancesAtOnePlaceBecomeTheirMeanByInverseVariance) {
  const Eigen::Vector3f center = 0.25F * Eigen::Vector3f(1, 2, 3);
  const float a = draw(random_, -0.5F, 0.5F);
  const float b = draw(random_, -0.5F, 0.5F);
  const float sure = draw(random_, 1e-4F, 1e-3F);
  const float unsure = draw(random_, 1e-2F, 1e-1F);
  for (const auto& [of_a, of_b] : {std::make_pair(sure, unsure), std::make_pair(unsure, sure)}) {
    AtomMap map = oneAtom(center, a, of_a);
    const MergeReport report = mergeInto(map, oneAtom(center, b, of_b), parametersOf(Mode::kSignedDistance));
    EXPECT_EQ(report.updates, 1U);
    const auto merged = map.atoms().nearest(center, kRadius);
    ASSERT_TRUE(merged);
    EXPECT_NEAR(merged->values[0], (a / of_a + b / of_b) / (1.0F / of_a + 1.0F / of_b), 1e-5F);
    EXPECT_NEAR(merged->values[1], 1.0F / (1.0F / of_a + 1.0F / of_b), 1e-6F);
  }
}

TEST(CombineMapsOfDistances, VariancesOfZeroAreNoDivisionByZero) {
  for (const float of_a : {0.0F, 0.1F}) {
    AtomMap map = oneAtom(Eigen::Vector3f::Zero(), 0.1F, of_a);
    mergeInto(map, oneAtom(Eigen::Vector3f::Zero(), 0.2F, 0.0F), parametersOf(Mode::kSignedDistance));
    const auto merged = map.atoms().nearest(Eigen::Vector3f::Zero(), kRadius);
    EXPECT_EQ(merged->values[0], of_a > 0.0F ? 0.2F : 0.1F);
    EXPECT_EQ(merged->values[1], 0.0F);
  }
}

// Atoms about a plane, each a lattice of its own; what one map's tell at the other's centres lies up to 2r along the normal.
TEST_P(CombineMaps, WhatAnAtomTellsIsTheDistanceWhereTheOtherLies) {
  const MappingParameters parameters = parametersOf(Mode::kSignedDistance);
  const Eigen::Vector3f normal = drawDirection(random_);
  const auto plane = [&](const Eigen::Vector3f& shift) {
    AtomMap map(Mode::kSignedDistance, parameters.radius);
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3f cell(static_cast<float>(i % 20), static_cast<float>(i / 20 % 20),
                                 static_cast<float>(i / 400));
      const Eigen::Vector3f center = 2.0F * kRadius * (cell - Eigen::Vector3f(10, 10, 2.5F)) + shift;
      const std::array<float, 2> values{normal.dot(center), 0.01F};
      map.atoms().insert(center, values.data());
    }
    return map;
  };
  AtomMap merged = plane(Eigen::Vector3f::Zero());
  const MergeReport report = mergeInto(merged, plane(drawWithin(random_, kRadius)), parameters);
  EXPECT_GT(report.updates, 2000U);
  double squares = 0.0;
  merged.atoms().forEach([&](const ConstAtomRef& atom) {
    squares += std::pow(static_cast<double>(atom.value() - normal.dot(atom.center())), 2);
  });
  EXPECT_LT(std::sqrt(squares / static_cast<double>(merged.atoms().size())), 0.02 * parameters.radius);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CombineMaps, tenSeeds());

}  // namespace
}  // namespace atom_map
