// Rays through maps in signed distance mode, against the regression that they follow and against exact truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "atom_mapping/map/mapper.h"
#include "atom_mapping/query/cast_ray.h"
#include "draw.h"
#include "simulated.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kMaxRange = 20.0;  // m

struct Ray {
  Vector3d origin;
  Vector3d direction;
  double range;  // m, to the true surface
};

struct RayFigures {
  double hit;     // share of the rays
  double median;  // radii, of the error of a hit's range
  double most;    // the same, that 90 % do not exceed
};

class SignedDistanceRays : public testing::TestWithParam<const char*> {
 protected:
  SignedDistanceRays() : drive_(makeDrive(GetParam(), 40)), mapper_(parameters()) {
    for (std::size_t i = 0; i < drive_.scans.size(); ++i) mapper_.insertScan(drive_.scans[i], drive_.poses[i]);
  }

  static MappingParameters parameters() {
    MappingParameters parameters;
    parameters.mode = Mode::kSignedDistance;
    return parameters;
  }

  // From random points of free space, up to `farthest` m in front of surfaces that the drive saw, towards these;
  // `least_cosine` to the surface's normal.
  std::vector<Ray> drawRays(int count, float farthest, double least_cosine) const {
    Random random(3);
    std::vector<Ray> rays;
    while (rays.size() < static_cast<std::size_t>(count)) {
      const std::size_t scan = drawIndex(random, drive_.simulated.size());
      const auto& returns = drive_.simulated[scan].returns;
      const SimulatedReturn& r = returns[drawIndex(random, returns.size())];
      if (r.point.norm() < 0.5F || r.point.norm() > 25.0F) continue;
      const Vector3d normal = drive_.poses[scan].linear() * r.true_normal.cast<double>();
      const Vector3d surface = drive_.poses[scan] * r.true_point.cast<double>();
      const Vector3d origin = surface + static_cast<double>(draw(random, 0.25F, farthest)) * normal;
      const Vector3d direction = drawDirection(random).cast<double>();
      if (-direction.dot(normal) < least_cosine || drive_.scene.signedDistance(origin) < 0.25) continue;
      const auto hit = drive_.scene.castRay(origin, direction, kMaxRange);
      if (hit) rays.push_back({origin, direction, hit->range});
    }
    return rays;
  }

  RayFigures judge(const std::vector<Ray>& rays) const {
    std::vector<double> errors;  // m
    int unknown = 0;
    for (const Ray& ray : rays) {
      const auto found = mapper_.read([&](const AtomMap& map) { return cast(map, ray); });
      unknown += found.end == RayEnd::kUnknown ? 1 : 0;
      if (found.end == RayEnd::kHit) errors.push_back(std::abs(static_cast<double>(found.distance) - ray.range));
    }
    std::sort(errors.begin(), errors.end());
    const auto share = [&](double part) {
      return errors.at(static_cast<std::size_t>(part * static_cast<double>(errors.size()))) /
             mapper_.parameters().radius;
    };
    const auto all = static_cast<double>(rays.size());
    const RayFigures figures{static_cast<double>(errors.size()) / all, share(0.5), share(0.9)};
    std::printf("%s: %.3f hit, %.3f unknown, error of the range %.3f r median, %.3f r at 90 %%, %.3f r at 95 %%\n",
                GetParam(), figures.hit, unknown / all, figures.median, figures.most, share(0.95));
    return figures;
  }

  CastRay cast(const AtomMap& map, const Ray& ray) const {
    GaussianProcess distances(map, mapper_.parameters().gaussian_process);
    return castRay(map, distances, map.toLocal(ray.origin), ray.direction.cast<float>(), kMaxRange);
  }

  // Asks the regression at every hundredth of a radius.
  CastRay castByForce(const AtomMap& map, const Ray& ray) const {
    GaussianProcess distances(map, mapper_.parameters().gaussian_process);
    const float step = 0.01F * map.radius();
    for (float distance = 0.0F; distance < kMaxRange; distance += step) {
      const auto there = distances.estimate(map.toLocal(ray.origin) + distance * ray.direction.cast<float>());
      if (!there) return {RayEnd::kUnknown, distance};
      if (there->value <= 0.0F) return {RayEnd::kHit, distance};
    }
    return {RayEnd::kMiss, kMaxRange};
  }

  Drive drive_;
  Mapper mapper_;
};

TEST_P(SignedDistanceRays, TowardsANearSurfaceHitItWhereItIs) {
  const RayFigures figures = judge(drawRays(4000, 0.375F, 0.98));
  EXPECT_GE(figures.hit, 0.97);
  EXPECT_LE(figures.median, 0.05);
  EXPECT_LE(figures.most, 0.35);
}

// Atoms lie along the surfaces' normals, between which the map knows less the farther from a surface.
TEST_P(SignedDistanceRays, FromFartherAndAskewMostHit) {
  const RayFigures figures = judge(drawRays(4000, 1.0F, 0.7));
  EXPECT_GE(figures.hit, 0.9);
  EXPECT_LE(figures.median, 0.05);
  EXPECT_LE(figures.most, 0.5);
}

// Save for unknown gaps that are thinner than a step.
TEST_P(SignedDistanceRays, EndWhereTheRegressionChangesSign) {
  int agree = 0;
  const std::vector<Ray> rays = drawRays(400, 1.5F, 0.5);
  for (const Ray& ray : rays) {
    const auto found = mapper_.read([&](const AtomMap& map) { return cast(map, ray); });
    const auto truth = mapper_.read([&](const AtomMap& map) { return castByForce(map, ray); });
    const double error = std::abs(found.distance - truth.distance);

    agree += found.end == truth.end && error < 0.021 * mapper_.parameters().radius ? 1 : 0;
  }
  std::printf("%s: %d of %zu agree\n", GetParam(), agree, rays.size());
  EXPECT_GE(agree, static_cast<int>(rays.size()) * 95 / 100);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SignedDistanceRays, testing::Values("hall", "campus"));

}  // namespace
}  // namespace atom_map
