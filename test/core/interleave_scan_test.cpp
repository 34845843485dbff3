// The law of interleaving for whole scans, from their rays to the free candidates that are left.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "atom_mapping/scan/rays.h"
#include "ring.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

// A wall around the sensor.
TEST(InterleavedScan, ThinsTheFreeCandidatesOfAScanToKTimesGammaAndNoOccupiedOne) {
  for (const double lambda : {0.0, 1.0, 10.0}) {
    MappingParameters parameters;
    parameters.radius = kRadius;
    parameters.rays.lambda = lambda;
    parameters.scan.thinning = 0.0;
    const Ring ring{1800, 10.0F - 3.0F * kRadius, static_cast<float>(lambda)};  // the second free candidates
    parameters.scan.horizontal_resolution = 360.0 / ring.rays;
    std::vector<SurfacePoint> wall;
    for (int i = 0; i < ring.rays; ++i) {
      const float azimuth = ring.resolution() * static_cast<float>(i);
      const Vector3f out(std::cos(azimuth), std::sin(azimuth), 0.0F);
      wall.push_back({10.0F * out, -out, std::numeric_limits<float>::infinity()});
    }
    constexpr int kScans = 100;
    int kept = 0;
    Random random(7);
    for (int scan = 0; scan < kScans; ++scan) {
      const Candidates candidates = traceRays(wall, {}, Vector3f::Zero(), parameters, random);
      ASSERT_EQ(candidates.occupied.size(), wall.size());
      ASSERT_EQ(candidates.proposed, 11U * wall.size());  // step A, and step B at 9.5, 8.5, ... 0.5 m
      for (const Candidate& free : candidates.free) {
        kept += std::abs(free.center.norm() - ring.distance) < 0.01F ? 1 : 0;
      }
    }
    const double gamma = ring.keepProbabilityAt(0.0F);
    const double draws = static_cast<double>(ring.rays) * kScans;
    const double error = kSigmas * std::sqrt(gamma * (1.0 - gamma) / draws);
    EXPECT_GE(kept / draws, ring.keepProbabilityAt(-1.0F) - error);
    EXPECT_LE(kept / draws, ring.keepProbabilityAt(1.0F) + error);
  }
}

}  // namespace
}  // namespace atom_map
