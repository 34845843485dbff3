#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "atom_mapping/base/random.h"
#include "atom_mapping/sim/make_scene.h"
#include "atom_mapping/sim/scene.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

double draw(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random.uniform());
}

Vector3d drawDirection(Random& random) {
  const double z = draw(random, -1.0, 1.0);
  const double azimuth = draw(random, -M_PI, M_PI);
  return {std::sqrt(1.0 - z * z) * std::cos(azimuth), std::sqrt(1.0 - z * z) * std::sin(azimuth), z};
}

Vector3d drawFreePoint(Random& random, const Scene& scene, double clearance = 0.01) {
  const Eigen::AlignedBox3d& box = scene.bounds();
  while (true) {
    Vector3d point;
    for (int i = 0; i < 3; ++i) point[i] = draw(random, box.min()[i], box.max()[i]);
    if (scene.signedDistance(point) > clearance) return point;
  }
}

// Follows the ray by the signed distance alone. Stops within 1e-9 m of a surface.
double traceSphere(const Scene& scene, const Vector3d& origin, const Vector3d& direction, double max_range) {
  double range = 0.0;
  while (range < max_range) {
    const double distance = scene.signedDistance(origin + range * direction);
    if (distance < 1e-9) return range;
    range += distance;
  }
  return max_range;
}

class SimScenes : public testing::TestWithParam<std::string> {
 protected:
  const Scene scene_ = makeScene(GetParam());
};

TEST_P(SimScenes, RayEndsWhereSphereTracingEnds) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vector3d origin = drawFreePoint(random, scene_);
    const Vector3d direction = drawDirection(random);
    const auto hit = scene_.castRay(origin, direction, 60.0);
    EXPECT_NEAR(hit ? hit->range : 60.0, traceSphere(scene_, origin, direction, 60.0), 1e-5);
  }
}

TEST_P(SimScenes, HitLiesOnASurfaceAndItsNormalPointsIntoFreeSpace) {
  Random random(2);
  int at_corners = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vector3d direction = drawDirection(random);
    const auto hit = scene_.castRay(drawFreePoint(random, scene_), direction, 100.0);
    if (!hit) continue;
    EXPECT_NEAR(scene_.signedDistance(hit->point), 0.0, 1e-9);
    EXPECT_NEAR(hit->normal.norm(), 1.0, 1e-12);
    EXPECT_LT(hit->normal.dot(direction), 0.0);
    if (std::abs(scene_.signedDistance(hit->point + 1e-3 * hit->normal) - 1e-3) > 1e-9) ++at_corners;
  }
  EXPECT_LT(at_corners, 25);
}

TEST_P(SimScenes, NoVisiblePointIsNearerThanTheSignedDistance) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Vector3d point = drawFreePoint(random, scene_);
    const Nearest nearest = scene_.nearest(point);
    EXPECT_NEAR(scene_.signedDistance(point - nearest.distance * nearest.normal), 0.0, 1e-9);
    const auto foot = scene_.castRay(point, -nearest.normal, 200.0);
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->range, nearest.distance, 1e-7);
    for (int k = 0; k < 200; ++k) {
      const auto hit = scene_.castRay(point, drawDirection(random), 200.0);
      EXPECT_GE(hit ? hit->range : 200.0, nearest.distance - 1e-9);
    }
  }
}

TEST_P(SimScenes, DepthInASolidIsNeverTooGreatAndMostlyExact) {
  Random random(6);
  int hits = 0;
  int exact = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto hit = scene_.castRay(drawFreePoint(random, scene_), drawDirection(random), 60.0);
    if (!hit) continue;
    const double depth = draw(random, 0.0, 0.3);
    const double distance = scene_.signedDistance(hit->point - depth * hit->normal);
    EXPECT_GE(distance, -depth - 1e-9);
    ++hits;
    if (std::abs(distance + depth) < 1e-9)
      ++exact;  // else it is nearer to another face, or has come out of a thin solid
  }
  EXPECT_GT(exact, 0.8 * hits);
}

TEST_P(SimScenes, NormalIsTheGradientOfTheSignedDistance) {
  Random random(4);
  int smooth = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d point = drawFreePoint(random, scene_);
    const Nearest nearest = scene_.nearest(point);
    Vector3d gradient;
    for (int k = 0; k < 3; ++k) {
      const Vector3d step = 1e-5 * Vector3d::Unit(k);
      gradient[k] = (scene_.signedDistance(point + step) - scene_.signedDistance(point - step)) / 2e-5;
    }
    if ((gradient - nearest.normal).norm() < 1e-3) ++smooth;  // else the point has two nearest ones
  }
  EXPECT_GT(smooth, 1980);
}

TEST_P(SimScenes, IsTheSameOnEveryCall) {
  const Scene again = makeScene(GetParam());
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Vector3d point = drawFreePoint(random, scene_);
    EXPECT_EQ(scene_.signedDistance(point), again.signedDistance(point));
  }
  EXPECT_EQ(again.name(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, SimScenes, testing::ValuesIn(sceneNames()),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace atom_map
