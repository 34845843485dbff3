// The measure of maps itself, on maps with a known answer.
#include "atom_mapping/sim/coverage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "draw.h"
#include "simulated.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.3;

// In the cube of 2 m: exact returns, a quarter of them said to be thin.
std::vector<ObservedRay> raysInCube(const Scene& cube) {
  Random random(1);
  std::vector<ObservedRay> rays;
  while (rays.size() < 20000) {
    const Vector3d sensor = drawWithin(random, 0.5F).cast<double>();
    const auto hit = cube.castRay(sensor, drawDirection(random).cast<double>().normalized(), 10.0);
    rays.push_back({sensor, hit->point, hit->normal, rays.size() % 4 == 0});
  }
  return rays;
}

class CoverageOf : public testing::Test {
 protected:
  Coverage measure(const AskOccupancy& ask, bool truth_is_known = true, std::uint64_t seed = 1) const {
    const auto distance = [this](const Vector3d& point) { return cube_.signedDistance(point); };
    return measureCoverage(rays_, kRadius, ask, truth_is_known ? distance : AskTrueDistance{}, seed);
  }
  Occupancy truth(const Vector3d& point) const {
    return cube_.signedDistance(point) > 1e-9 ? Occupancy::kFree : Occupancy::kOccupied;
  }

  const Scene cube_ = makeScene("cube");
  const std::vector<ObservedRay> rays_ = raysInCube(cube_);
};

TEST_F(CoverageOf, ATrueMapIsComplete) {
  const Coverage coverage = measure([&](const Vector3d& point) { return truth(point); });
  EXPECT_EQ(coverage.free.value(), 1.0);
  EXPECT_EQ(coverage.false_occupied.value(), 0.0);
  EXPECT_EQ(coverage.unknown.value(), 0.0);
  EXPECT_EQ(coverage.surface.value(), 1.0);
  EXPECT_EQ(coverage.thin.value(), 1.0);
  EXPECT_EQ(coverage.surface.whole, rays_.size());
  EXPECT_EQ(coverage.thin.whole, rays_.size() / 4);
  EXPECT_GT(coverage.free.whole, rays_.size() / 4);
}

TEST_F(CoverageOf, AMapOfOneAnswerHasThatShareOnly) {
  const Coverage free = measure([](const Vector3d&) { return Occupancy::kFree; });
  EXPECT_EQ(free.free.value(), 1.0);
  EXPECT_EQ(free.surface.value() + free.thin.value() + free.false_occupied.value() + free.unknown.value(), 0.0);
  const Coverage unknown = measure([](const Vector3d&) { return Occupancy::kUnknown; });
  EXPECT_EQ(unknown.unknown.value(), 1.0);
  EXPECT_EQ(unknown.surface.value() + unknown.thin.value() + unknown.false_occupied.value() + unknown.free.value(),
            0.0);
  const Coverage occupied = measure([](const Vector3d&) { return Occupancy::kOccupied; });
  EXPECT_EQ(occupied.surface.value() * occupied.thin.value() * occupied.false_occupied.value(), 1.0);
  EXPECT_EQ(occupied.free.value() + occupied.unknown.value(), 0.0);
}

TEST_F(CoverageOf, AMapWithHolesMissesTheirShare) {
  Random random(2);
  const Coverage coverage = measure([&](const Vector3d& point) {
    const float chance = random.uniform();
    if (chance < 0.2F) return Occupancy::kUnknown;
    return chance < 0.3F ? Occupancy::kOccupied : truth(point);
  });
  const double error = 5.0 * std::sqrt(0.25 / static_cast<double>(coverage.free.whole));
  EXPECT_NEAR(coverage.unknown.value(), 0.2, error);
  EXPECT_NEAR(coverage.false_occupied.value(), 0.1, error);
  EXPECT_NEAR(coverage.surface.value(), 0.8, error);
}

TEST_F(CoverageOf, PointsLieOnTheRaysShortOfTheReturnAndClearOfEverySurface) {
  for (const bool truth_is_known : {true, false}) {
    std::vector<Vector3d> asked;
    measure(
        [&](const Vector3d& point) {
          asked.push_back(point);
          return Occupancy::kUnknown;
        },
        truth_is_known);
    std::size_t next = 0;
    std::size_t near_a_surface = 0;
    for (const ObservedRay& ray : rays_) {
      EXPECT_LT((asked.at(next++) - (ray.end - kRadius * *ray.normal)).norm(), 1e-9) << "beneath the surface";
      if (ray.thin && asked.at(next++) != ray.end) FAIL() << "the return of a thin thing";
      if (next == asked.size()) break;
      const Vector3d along = (ray.end - ray.sensor).normalized();
      const double range = along.dot(asked[next] - ray.sensor);
      if ((ray.sensor + range * along - asked[next]).norm() > 1e-9) continue;  // none of this ray: the next ray's
      EXPECT_GE(range, 0.0);
      EXPECT_LE(range, (ray.end - ray.sensor).norm() - 2.0 * kRadius + 1e-9);
      near_a_surface += cube_.signedDistance(asked[next]) < kRadius ? 1 : 0;
      ++next;
    }
    EXPECT_EQ(next, asked.size());
    EXPECT_EQ(near_a_surface == 0, truth_is_known);
  }
}

TEST_F(CoverageOf, SurfaceIsSoughtAlongTheRayWhereTheTruthIsUnknown) {
  std::vector<Vector3d> asked;
  const ObservedRay ray{Vector3d::Zero(), {0.5, 0.0, 0.0}, std::nullopt, false};
  measureCoverage(
      {ray}, kRadius,
      [&](const Vector3d& point) {
        asked.push_back(point);
        return Occupancy::kOccupied;
      },
      AskTrueDistance{}, 1);
  ASSERT_EQ(asked.size(), 1U) << "a ray shorter than two radii has no point of free space";
  EXPECT_LT((asked[0] - Vector3d(0.8, 0.0, 0.0)).norm(), 1e-9);
}

TEST_F(CoverageOf, SameSeedDrawsTheSamePoints) {
  const auto mark = [](const Vector3d& point) { return point.x() > 0.1 ? Occupancy::kFree : Occupancy::kUnknown; };
  EXPECT_EQ(measure(mark, true, 3).free.part, measure(mark, true, 3).free.part);
  EXPECT_NE(measure(mark, true, 3).free.part, measure(mark, true, 4).free.part);
}

}  // namespace
}  // namespace atom_map
