// Signed distance mode against exact truth, and its stages.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "atom_mapping/map/mapper.h"
#include "atom_mapping/query/gaussian_process.h"
#include "atom_mapping/scan/drop_crossing.h"
#include "atom_mapping/scan/normal_rays.h"
#include "draw.h"
#include "simulated.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

struct DistanceError {
  double rms = 0.0;     // m
  double known = 0.0;   // share
  double facing = 0.0;  // mean cosine between gradient and true normal
};

// At points within 2r of surfaces that the drive's rays met, on both sides, a quarter of the returns, one each.
DistanceError errorOf(const Drive& drive, const MappingParameters& parameters, const AtomMap& map) {
  GaussianProcess process(map, parameters.gaussian_process);
  Random random(5);
  std::size_t asked = 0;
  std::size_t known = 0;
  double squares = 0.0;
  double cosines = 0.0;
  for (std::size_t i = 0; i < drive.simulated.size(); ++i) {
    for (std::size_t k = i % 4; k < drive.simulated[i].returns.size(); k += 4) {
      const SimulatedReturn& r = drive.simulated[i].returns[k];
      if (r.point.norm() < 0.5F || r.point.norm() > 25.0F) continue;
      const Vector3d normal = drive.poses[i].linear() * r.true_normal.cast<double>();
      const double offset = (3.0 * static_cast<double>(random.uniform()) - 1.0) * parameters.radius;  // -r to 2r
      const Vector3d query = drive.poses[i] * r.true_point.cast<double>() + offset * normal;
      const Nearest truth = drive.scene.nearest(query);
      if (truth.distance > 2.0 * parameters.radius || truth.distance < -parameters.radius) continue;
      ++asked;
      const auto estimate = process.estimate(map.toLocal(query));
      if (!estimate) continue;
      ++known;
      squares += std::pow(static_cast<double>(estimate->value) - truth.distance, 2);
      cosines += estimate->gradient.cast<double>().normalized().dot(truth.normal);
    }
  }
  const auto count = static_cast<double>(known);
  return {std::sqrt(squares / count), count / static_cast<double>(asked), cosines / count};
}

class SignedDistance : public testing::TestWithParam<const char*> {};

TEST_P(SignedDistance, ReachesItsFigures) {
  const Drive drive = makeDrive(GetParam(), 40);
  MappingParameters parameters;
  parameters.mode = Mode::kSignedDistance;
  Mapper mapper(parameters);
  ScanReport report;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) report = mapper.insertScan(drive.scans[i], drive.poses[i]);
  const DistanceError error = mapper.read([&](const AtomMap& map) { return errorOf(drive, parameters, map); });
  std::printf("%s r %.2f: signed distance rms %.3f r, known %.4f, mean cosine %.3f, %.1f bytes an atom\n", GetParam(),
              parameters.radius, error.rms / parameters.radius, error.known, error.facing,
              static_cast<double>(report.map_bytes) / static_cast<double>(report.atoms));
  EXPECT_LE(error.rms, 0.25 * parameters.radius);
  EXPECT_GE(error.known, 0.9);
  EXPECT_GE(error.facing, 0.9);
  EXPECT_LE(report.map_bytes, 32 * report.atoms);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SignedDistance, testing::Values("hall", "campus"));

TEST(NormalRays, LieAlongTheNormalWithTheirDistance) {
  MappingParameters parameters;
  parameters.mode = Mode::kSignedDistance;
  parameters.rays.lambda = 0.0;
  Random random(1);
  const float infinity = std::numeric_limits<float>::infinity();
  for (int i = 0; i < 100; ++i) {
    const Vector3f normal = drawWithin(random, 1.0F).normalized();
    const SurfacePoint point{drawWithin(random, 20.0F), normal, infinity};
    const DistanceCandidates candidates = traceNormals({point}, point.position + 10.0F * normal, parameters, random);
    ASSERT_EQ(candidates.behind.size(), 1U);
    EXPECT_FLOAT_EQ(candidates.behind[0].distance, -0.25F);
    EXPECT_EQ(candidates.proposed, 1U + 4U);  // in front at r, 3r, 5r and 7r of the 2 m
    for (const auto* side : {&candidates.behind, &candidates.infront}) {
      for (const DistanceCandidate& c : *side) {
        EXPECT_NEAR((c.center - point.position - c.distance * normal).norm(), 0.0F, 1e-5F);
      }
    }
  }
}

TEST(DropCrossing, DropsWhatAnotherSurfaceIsNearerTo) {
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<SurfacePoint> surface{{{0, 0, 0}, Vector3f::UnitZ(), infinity},
                                          {{0, 0, 1.5F}, -Vector3f::UnitZ(), infinity}};
  DistanceCandidates candidates;
  for (const float distance : {0.25F, 0.75F, 1.25F}) {
    candidates.infront.push_back({{0, 0, distance}, distance, Vector3f::UnitZ()});
  }
  candidates.behind = {{{0, 0, -0.25F}, -0.25F, Vector3f::UnitZ()}, {{0, 0, 1.4F}, -0.25F, Vector3f::UnitX()}};
  dropCrossing(surface, 0.01F, candidates);
  ASSERT_EQ(candidates.infront.size(), 2U);  // at 1.25 m the other surface is 0.25 m away
  EXPECT_FLOAT_EQ(candidates.infront[1].distance, 0.75F);
  ASSERT_EQ(candidates.behind.size(), 1U);
  EXPECT_FLOAT_EQ(candidates.behind[0].center.z(), -0.25F);
}

}  // namespace
}  // namespace atom_map
