// The law of stochastic angular interleaving (paper III-D): with the probability of Eq. (2), about one of the
// candidates that overlap one another remains.
#include "atom_mapping/scan/interleave.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ring.h"

namespace atom_map {
namespace {

std::vector<Ring> rings() {
  std::vector<Ring> all;
  for (const float lambda : {0.0F, 0.5F, 1.0F, 4.0F, 30.0F}) {
    for (const float distance : {3.0F, 9.7F, 24.0F}) {
      for (const int rays : {180, 720, 1800}) all.push_back({rays, distance, lambda});
    }
  }
  return all;
}

// What remains in the overlapping set of one candidate, scan after scan: the mean, and how often nothing does.
struct Remains {
  double mean = 0.0;
  double none = 0.0;
};

Remains interleave(const Ring& ring, int scans, std::uint64_t seed) {
  Random random(seed);
  Interleaver interleaver(kRadius, ring.lambda, kMaxDistance, random);
  const auto set = static_cast<std::size_t>(ring.overlapping());
  const std::vector<float> distances(set, ring.distance);
  const std::vector<float> rays_per_radian(set, 1.0F / ring.resolution());
  Remains remains;
  for (int scan = 0; scan < scans; ++scan) {
    int kept = 0;
    interleaver.keepEach(distances, rays_per_radian, [&](std::uint32_t) { ++kept; });
    remains.mean += static_cast<double>(kept) / scans;
    remains.none += kept == 0 ? 1.0 / scans : 0.0;
  }
  return remains;
}

TEST(Interleaving, Equation1CountsTheOverlappingSetAndAtMostOneMoreOnEachSide) {
  for (const Ring& ring : rings()) {
    const float k = overlapCount(touchingAngle(kRadius, ring.distance), 1.0F / ring.resolution());
    EXPECT_GE(k, static_cast<float>(ring.overlapping()));
    EXPECT_LE(k, static_cast<float>(ring.overlapping() + 2));
  }
}

TEST(Interleaving, LeavesKTimesGammaOfEachOverlappingSet) {
  constexpr int kScans = 20000;
  for (const Ring& ring : rings()) {
    const double k = ring.overlapping();
    const double gamma = ring.keepProbabilityAt(0.0F);
    const double error = kSigmas * std::sqrt(k * gamma * (1.0 - gamma) / kScans);
    const double mean = interleave(ring, kScans, 1).mean;
    EXPECT_GE(mean, k * ring.keepProbabilityAt(-1.0F) - error) << ring.distance << " m, lambda " << ring.lambda;
    EXPECT_LE(mean, k * ring.keepProbabilityAt(1.0F) + error) << ring.distance << " m, lambda " << ring.lambda;
  }
}

TEST(Interleaving, LeavesAboutOneWhereHolesCostNothing) {
  for (const Ring& ring : {Ring{1800, 3.0F, 0.0F}, Ring{1800, 9.7F, 0.0F}, Ring{7200, 24.0F, 0.0F}}) {
    EXPECT_NEAR(interleave(ring, 20000, 2).mean, 1.0, 0.08);
  }
}

TEST(Interleaving, LeavesNothingAsOftenAsIndependentDrawsDo) {
  constexpr int kScans = 20000;
  for (const Ring& ring : rings()) {
    const auto none = [&](float error) { return std::pow(1.0 - ring.keepProbabilityAt(error), ring.overlapping()); };
    const double error = kSigmas * std::sqrt(none(0.0F) * (1.0 - none(0.0F)) / kScans) + kSigmas / kScans;
    const double share = interleave(ring, kScans, 3).none;
    EXPECT_LE(share, none(-1.0F) + error);
    EXPECT_GE(share, none(1.0F) - error);
  }
}

// One may be looked up an eighth of a radius too near or too far.
float keptAt(float distance, float resolution) {
  return keepProbability(overlapCount(touchingAngle(kRadius, distance), 1.0F / resolution), 1.0F);
}

TEST(Interleaving, AlongARayEachStaysByItsProbabilityAndTheirNumberByTheSumOfThem) {
  constexpr int kRays = 20000;
  constexpr float kStep = kRadius / 8.0F;
  for (const float resolution : {0.0035F, 0.02F, 0.3F}) {
    for (const float distance : {24.0F, 10.13F, 2.0F * kRadius, 0.3F * kRadius, 1e-4F}) {
      Random random(7);
      Interleaver interleaver(kRadius, 1.0F, kMaxDistance, random);
      const auto count = static_cast<std::uint32_t>(std::ceil(distance / (2.0F * kRadius)));
      float least = 0.0F;
      float most = 0.0F;
      for (std::uint32_t i = 0; i < count; ++i) {
        const float along = distance - 2.0F * kRadius * static_cast<float>(i);
        least += keptAt(std::max(along - kStep, 1e-4F), resolution);
        most += keptAt(along + kStep, resolution);
      }
      std::vector<int> kept(count, 0);
      for (int ray = 0; ray < kRays; ++ray) {
        float number = 0.0F;
        interleaver.keepAlong(distance, count, resolution, [&](std::uint32_t i) {
          ++kept.at(i);
          ++number;
        });
        ASSERT_GE(number, std::floor(least)) << distance << " m, " << resolution;
        ASSERT_LE(number, std::ceil(most)) << distance << " m, " << resolution;
      }
      for (std::uint32_t i = 0; i < count; ++i) {
        const float along = distance - 2.0F * kRadius * static_cast<float>(i);
        const double share = static_cast<double>(kept[i]) / kRays;
        const double error = kSigmas * std::sqrt(0.25 / kRays);
        EXPECT_GE(share, keptAt(std::max(along - kStep, 1e-4F), resolution) - error) << i << " of " << count;
        EXPECT_LE(share, keptAt(along + kStep, resolution) + error) << i << " of " << count;
      }
    }
  }
}

TEST(Interleaving, SameSeedDrawsTheSameAndAnotherSeedOthers) {
  const auto draws = [](std::uint64_t seed) {
    Random random(seed);
    Interleaver interleaver(kRadius, 1.0F, kMaxDistance, random);
    std::vector<float> distances;
    for (int i = 0; i < 1000; ++i) distances.push_back(0.02F * static_cast<float>(i));
    std::vector<std::uint32_t> kept;
    interleaver.keepEach(distances, std::vector<float>(1000, 300.0F), [&](std::uint32_t i) { kept.push_back(i); });
    return kept;
  };
  EXPECT_EQ(draws(4), draws(4));
  EXPECT_NE(draws(4), draws(5));
}

TEST(Interleaving, EveryDistanceUpToTheLongestMayBeAskedFor) {
  Random random(6);
  Interleaver interleaver(kRadius, 1.0F, kMaxDistance, random);
  int kept = 0;
  interleaver.keepEach({0.0F, 1e-6F, kMaxDistance}, {0.3F, 0.3F, 0.3F}, [&](std::uint32_t) { ++kept; });
  EXPECT_LE(kept, 3);
}

}  // namespace
}  // namespace atom_map
