// Equations (3), (4) and (5) of the paper, update, overlap and interpolation, against values computed by hand, their
// limits, and what they are derived from.
#include <gtest/gtest.h>

#include <cmath>

#include "atom_mapping/map/merge.h"
#include "atom_mapping/map/overlap.h"
#include "atom_mapping/query/occupancy.h"
#include "draw.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

TEST(Equation4, OverlapByHand) {
  EXPECT_FLOAT_EQ(overlapFraction(0.0F), 1.0F);
  EXPECT_FLOAT_EQ(overlapFraction(0.25F),
                  1.0F - 0.5F / 4.0F * (3.0F - 0.0625F));  // d = r / 2
  EXPECT_FLOAT_EQ(overlapFraction(0.5F), 0.3125F);         // d = r
  EXPECT_FLOAT_EQ(overlapFraction(0.75F), 0.0859375F);     // d = 3 r / 2
  EXPECT_FLOAT_EQ(overlapFraction(1.0F), 0.0F);
  EXPECT_FLOAT_EQ(overlapFraction(5.0F), 0.0F);
}

TEST(Equation4, OverlapFallsAndStaysWithinZeroAndOne) {
  float last = 1.0F;
  for (float t = 0.0F; t <= 1.0F; t += 1e-5F) {
    ASSERT_LE(overlapFraction(t), last + 1e-7F);
    last = overlapFraction(t);
  }
  for (float t = 0.999F; t <= 1.001F; t = std::nextafter(t, 2.0F)) ASSERT_GE(overlapFraction(t), 0.0F) << t;
}

TEST(Equation4, OverlapIsTheShareOfVolumeInBothSpheres) {
  Random random(3);
  constexpr int kPoints = 200000;
  for (const float distance_over_diameter : {0.05F, 0.2F, 0.5F, 0.8F, 0.95F}) {
    const Vector3f other(2.0F * distance_over_diameter, 0.0F, 0.0F);  // radius 1
    int inside = 0;
    int in_both = 0;
    while (inside < kPoints) {
      const Vector3f point = drawWithin(random, 1.0F);
      if (point.squaredNorm() >= 1.0F) continue;
      ++inside;
      in_both += (point - other).squaredNorm() < 1.0F ? 1 : 0;
    }
    const double share = static_cast<double>(in_both) / kPoints;
    const double error = std::sqrt(share * (1.0 - share) / kPoints);
    EXPECT_NEAR(overlapFraction(distance_over_diameter), share, 5.0 * error + 1e-5);
  }
}

AtomMap makeMap(const std::vector<Candidate>& atoms) {
  AtomMap map(Mode::kOccupancy, 0.5);
  for (const Candidate& atom : atoms) map.atoms().insert(atom.center, &atom.value);
  return map;
}

float valueAt(const AtomMap& map, const Vector3f& center) {
  return map.atoms().nearest(center, 0.01F)->values[0];
}

TEST(Equation3, UpdateAddsTheOverlapTimesTheNewLogOdds) {
  AtomMap map = makeMap({{{0.0F, 0.0F, 0.0F}, 1.0F}, {{1.25F, 0.0F, 0.0F}, -1.0F}, {{0.0F, 3.0F, 0.0F}, 0.5F}});
  OccupancyMerge merge(map, OccupancyParameters{});
  const Candidate candidate{{0.5F, 0.0F, 0.0F}, -0.4F};  // r from the first, 3/2 r from the second
  merge.add(&candidate, &candidate + 1);
  EXPECT_FLOAT_EQ(valueAt(map, {0.0F, 0.0F, 0.0F}), 1.0F - 0.3125F * 0.4F);
  EXPECT_FLOAT_EQ(valueAt(map, {1.25F, 0.0F, 0.0F}), -1.0F - 0.0859375F * 0.4F);
  EXPECT_FLOAT_EQ(valueAt(map, {0.0F, 3.0F, 0.0F}), 0.5F);
  EXPECT_EQ(map.atoms().size(), 3U);
  EXPECT_EQ(merge.report().updates, 2U);
}

TEST(Equation5, InterpolationByHand) {
  const AtomMap map = makeMap({{{0.5F, 0.0F, 0.0F}, 2.0F}, {{-0.25F, 0.0F, 0.0F}, -1.0F}, {{0.0F, 9.0F, 0.0F}, 3.0F}});
  const auto value = interpolate(map, Vector3f::Zero());  // weights 0.3125 and 0.6328125
  ASSERT_TRUE(value);
  EXPECT_NEAR(*value, (0.3125F * 2.0F - 0.6328125F) / 0.9453125F, 1e-6F);
}

TEST(Equation5, OneAtomSpeaksAloneUpToTwoRadii) {
  const AtomMap map = makeMap({{Vector3f::Zero(), -0.7F}});
  for (const float x : {0.0F, 0.3F, 0.99F}) EXPECT_FLOAT_EQ(interpolate(map, {x, 0.0F, 0.0F}).value_or(9.0F), -0.7F);
  for (const float x : {1.0F, 1.01F, 50.0F}) EXPECT_FALSE(interpolate(map, {x, 0.0F, 0.0F})) << x;
}

}  // namespace
}  // namespace atom_map
