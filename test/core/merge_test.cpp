// Merging (paper III-E) against the same rules applied to a plain list.
#include "atom_mapping/map/merge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "atom_mapping/scan/snap.h"
#include "check_map.h"
#include "list_merge.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

MergeReport add(AtomMap& map, const Scan& scan, const OccupancyParameters& parameters, std::size_t slice = 1000000) {
  OccupancyMerge merge(map, parameters);
  for (const auto* part : {&scan.occupied, &scan.free}) {
    for (std::size_t i = 0; i < part->size(); i += slice) {
      merge.add(part->data() + i, part->data() + std::min(i + slice, part->size()));
    }
  }
  return merge.report();
}

SortedAtoms atomsOf(const AtomMap& map) {
  SortedAtoms atoms;
  map.atoms().forEach([&](ConstAtomRef atom) {
    atoms.push_back({atom.center().x(), atom.center().y(), atom.center().z(), atom.value()});
  });
  std::sort(atoms.begin(), atoms.end());
  return atoms;
}

class Merge : public testing::TestWithParam<int> {
 protected:
  Merge() : random_(static_cast<std::uint64_t>(GetParam())) {
    parameters_.max_log_odds = 1.5;  // reached soon
    half_ = draw(random_, 0.5F, 4.0F);
  }

  Random random_;
  OccupancyParameters parameters_;
  float half_;
};

TEST_P(Merge, GivesTheAtomsThatTheRulesGiveToAList) {
  AtomMap map(Mode::kOccupancy, kRadius);
  ListMerge list(parameters_);
  for (int i = 0; i < 6; ++i) {
    const Scan scan = drawScan(random_, half_);
    add(map, scan, parameters_);
    list.add(scan);
    const auto atoms = atomsOf(map);
    const auto expected = list.atoms();
    ASSERT_EQ(atoms.size(), expected.size());
    for (std::size_t k = 0; k < atoms.size(); ++k) {
      for (int c = 0; c < 3; ++c) ASSERT_EQ(atoms[k][c], expected[k][c]);
      ASSERT_NEAR(atoms[k][3], expected[k][3], 1e-4F);
    }
  }
}

TEST_P(Merge, KeepsAtomsApartAndLogOddsWithinTheClamps) {
  parameters_.hit_probability = 0.99;  // one hit is more than the clamp
  AtomMap map(Mode::kOccupancy, kRadius);
  for (int i = 0; i < 6; ++i) {
    Scan scan = drawScan(random_, half_);
    for (Candidate& candidate : scan.occupied) candidate.value = 4.6F;
    const std::size_t before = map.atoms().size();
    const MergeReport report = add(map, scan, parameters_);
    EXPECT_EQ(map.atoms().size(), before + report.inserted);
    expectNoOverlap(map);
    expectWithinClamps(map, parameters_.max_log_odds);
  }
}

TEST_P(Merge, InSlicesGivesTheSameBytes) {
  AtomMap whole(Mode::kOccupancy, kRadius);
  AtomMap sliced(Mode::kOccupancy, kRadius);
  for (int i = 0; i < 3; ++i) {
    const Scan scan = drawScan(random_, half_);
    const MergeReport at_once = add(whole, scan, parameters_);
    const MergeReport in_slices = add(sliced, scan, parameters_, 7);
    EXPECT_EQ(at_once.inserted, in_slices.inserted);
    EXPECT_EQ(at_once.updates, in_slices.updates);
    EXPECT_EQ(bytesOf(whole), bytesOf(sliced));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Merge, testing::Range(1, 16));

TEST(MergeOfOneCandidate, TangentAtomsAreNoOverlap) {
  AtomMap map(Mode::kOccupancy, kRadius);
  Scan ray;
  for (int i = 0; i < 50; ++i) ray.free.push_back({0.5F * static_cast<float>(i) * Vector3f(0.6F, 0.8F, 0), -0.4F});
  EXPECT_EQ(add(map, ray, OccupancyParameters{}).inserted, 50U) << "along a ray each touches the next";
}

TEST(MergeOfOneCandidate, AnAtomThatAReturnRaisedIsNotLoweredByItsOwnScanButByTheNext) {
  const Candidate hit{Vector3f::Zero(), 0.8F};
  const Candidate miss{{0.1F, 0.0F, 0.0F}, -0.4F};
  AtomMap map(Mode::kOccupancy, kRadius);
  add(map, {{hit}, {miss}}, OccupancyParameters{});
  EXPECT_FLOAT_EQ(atomsOf(map).at(0)[3], 0.8F);
  add(map, {{}, {miss}}, OccupancyParameters{});
  EXPECT_LT(atomsOf(map).at(0)[3], 0.6F);
  EXPECT_EQ(map.atoms().size(), 1U);
}

TEST_P(Merge, OfCandidatesThatStandAsideKeepsAtomsApartAndLogOddsWithinTheClamps) {
  AtomMap map(Mode::kOccupancy, kRadius);
  for (int i = 0; i < 4; ++i) {
    Scan scan = drawScan(random_, half_);
    for (Candidate& candidate : scan.occupied)
      candidate.aside = random_.uniform() < 0.5F ? Aside::kOfAll : Aside::kNever;
    for (Candidate& candidate : scan.free) candidate.aside = Aside::kOfOne;
    const std::size_t before = map.atoms().size();
    const MergeReport report = add(map, scan, parameters_);
    EXPECT_EQ(map.atoms().size(), before + report.inserted);
    expectNoOverlap(map);
    expectWithinClamps(map, parameters_.max_log_odds);
  }
}

TEST(MergeOfAThinThing, SetsAnAtomAsideOfThoseThatLieFarFromIt) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    AtomMap map(Mode::kOccupancy, kRadius);
    const Vector3f free = drawWithin(random, 3.0F);
    add(map, {{}, {{free, -0.4F}}}, OccupancyParameters{});
    const float distance = draw(random, 0.05F, 1.99F) * kRadius;
    const Candidate pole{free + distance * drawDirection(random), 1.7F, kRadius, Aside::kOfAll};
    const MergeReport report = add(map, {{pole}, {}}, OccupancyParameters{});
    const bool is_far = distance > kRadius;
    ASSERT_EQ(report.inserted, is_far ? 1U : 0U) << distance << " m off";
    if (!is_far) continue;
    const auto nearest = map.atoms().nearest(pole.center, kRadius);
    ASSERT_TRUE(nearest && nearest->values[0] > 0.0F);
    ASSERT_NEAR((nearest->center - free).norm(), 2.0F * kRadius, latticeSpacing(kRadius))
        << "it touches the atom that was there";
  }
}

TEST(MergeOfAFreeCandidate, StandsAsideOfALoneAtomThatItOverlapsByLittle) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    AtomMap map(Mode::kOccupancy, kRadius);
    const Vector3f lone = drawWithin(random, 3.0F);
    add(map, {{}, {{lone, -0.4F}}}, OccupancyParameters{});
    const float distance = draw(random, 0.05F, 1.99F) * kRadius;
    const Candidate free{lone + distance * drawDirection(random), -0.4F, 0.0F, Aside::kOfOne};
    ASSERT_EQ(add(map, {{}, {free}}, OccupancyParameters{}).inserted, distance > 1.4F * kRadius ? 1U : 0U) << distance;
    expectNoOverlap(map);
  }
}

TEST(MergeOfAFreeCandidate, StaysOutWhereItOverlapsTwo) {
  AtomMap map(Mode::kOccupancy, kRadius);
  const Candidate left{{-1.6F * kRadius, 0.0F, 0.0F}, -0.4F};
  const Candidate right{{1.6F * kRadius, 0.0F, 0.0F}, -0.4F};
  const Candidate between{Vector3f::Zero(), -0.4F, 0.0F, Aside::kOfOne};
  EXPECT_EQ(add(map, {{}, {left, right, between}}, OccupancyParameters{}).inserted, 2U);
}

// Three atoms that touch one another, each at `distance` radii from it on one side: away from them is room, but how far?
TEST(MergeOfAThinThing, IsPushedByARadiusAtMost) {
  for (const float distance : {1.4F, 1.5F}) {
    constexpr float kApart = 1.156F;  // radii, from their middle: 2.002 from one another
    const float behind = std::sqrt(distance * distance - kApart * kApart);
    AtomMap map(Mode::kOccupancy, kRadius);
    Scan three;
    for (const float turn : {0.0F, 2.0944F, 4.1888F}) {
      three.free.push_back({kRadius * Vector3f(kApart * std::cos(turn), kApart * std::sin(turn), -behind), -0.4F});
    }
    ASSERT_EQ(add(map, three, OccupancyParameters{}).inserted, 3U);
    const float push = 3.0F * (2.0F - distance) * behind / distance;  // radii
    ASSERT_GT(std::hypot(kApart, behind + push), 2.0F) << "there is room";
    const Candidate pole{Vector3f::Zero(), 1.7F, kRadius, Aside::kOfAll};
    EXPECT_EQ(add(map, {{pole}, {}}, OccupancyParameters{}).inserted, push > 1.0F ? 0U : 1U) << distance;
  }
}

TEST(MergeOfAThinThing, InsertsNothingWhereThereIsNoRoom) {
  AtomMap map(Mode::kOccupancy, kRadius);
  Scan corners;  // of a cube, 1.73 radii from its middle: what is pushed out of one lies in others
  for (const float x : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F}) {
      for (const float z : {-1.0F, 1.0F}) corners.free.push_back({1.001F * kRadius * Vector3f(x, y, z), -0.4F});
    }
  }
  ASSERT_EQ(add(map, corners, OccupancyParameters{}).inserted, 8U);
  EXPECT_EQ(add(map, {{{Vector3f::Zero(), 1.7F, kRadius, Aside::kOfAll}}, {}}, OccupancyParameters{}).inserted, 0U);
}

}  // namespace
}  // namespace atom_map
