// Which returns share the normal of a plane that was fitted to others.
#include "atom_mapping/scan/shared_planes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "draw.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr float kCell = 1.0F;        // m; a wide one has 8 m
constexpr float kTolerance = 0.05F;  // m

// A wall three metres before the sensor, square to x but for a turn about z (radians).
Patch wall(float turn = 0.0F) {
  return {Vector3f(-std::cos(turn), -std::sin(turn), 0.0F), 3.0F * std::cos(turn)};
}

Vector3f onWall(float y, float z) {
  return {3.0F, y, z};
}

TEST(SharedPlanes, AReturnOfTheSameCellSharesOneThatItLiesOn) {
  SharedPlanes planes(kCell, kTolerance, 100);
  EXPECT_FALSE(planes.normalAt(onWall(0.1F, 0.1F)));
  planes.add(wall(), onWall(0.1F, 0.1F));
  EXPECT_EQ(planes.normalAt(onWall(0.9F, 0.9F)), wall().normal);
  EXPECT_EQ(planes.normalAt({3.04F, 0.5F, 0.5F}), wall().normal);
  EXPECT_FALSE(planes.normalAt({3.06F, 0.5F, 0.5F})) << "beyond the tolerance";
  EXPECT_FALSE(planes.normalAt(onWall(1.1F, 0.5F))) << "the next cell";
}

TEST(SharedPlanes, AReturnOfAWideCellSharesOneThatThreeFitsAgreeOn) {
  SharedPlanes planes(kCell, kTolerance, 100);
  for (const float turn : {-0.01F, 0.0F, 0.01F}) {
    EXPECT_FALSE(planes.normalAt(onWall(5.5F, 5.5F)));
    planes.add(wall(turn), onWall(0.5F + 100.0F * (turn + 0.01F), 0.5F));
  }
  const auto shared = planes.normalAt(onWall(5.5F, 5.5F));
  ASSERT_TRUE(shared);
  EXPECT_NEAR((*shared - wall().normal).norm(), 0.0F, 1e-4F) << "the mean of the three";
  EXPECT_FALSE(planes.normalAt({3.2F, 6.5F, 5.5F})) << "beyond the tolerance";
  EXPECT_FALSE(planes.normalAt(onWall(8.5F, 5.5F))) << "the next wide cell";
}

TEST(SharedPlanes, FitsToACurvedSurfaceDoNotAgree) {
  SharedPlanes planes(kCell, kTolerance, 100);
  for (int i = 0; i < 20; ++i) {  // a column of 2 m, 5 m away, every three degrees
    const float angle = static_cast<float>(i - 10) * 0.0524F;
    const Vector3f normal(-std::cos(angle), std::sin(angle), 0.0F);
    const Vector3f point = Vector3f(5.0F, 0.0F, 0.5F) + 2.0F * normal;
    planes.add({normal, -normal.dot(point)}, point);
    EXPECT_FALSE(planes.normalAt(point + Vector3f::UnitZ())) << i;
  }
}

// Floor and wall: wherever the fits came from, a shared normal is that of a plane within the tolerance that faces the sensor.
TEST(SharedPlanes, AReturnLiesOnThePlaneWhoseNormalItShares) {
  Random random(1);
  SharedPlanes planes(kCell, kTolerance, 100);
  const Patch floor{Vector3f::UnitZ(), 1.5F};
  int shared = 0;
  for (int i = 0; i < 5000; ++i) {
    const bool on_floor = random.uniform() < 0.5F;
    const float across = draw(random, 0.0F, 20.0F);
    const float along = draw(random, 0.0F, 3.0F);
    const Vector3f point = on_floor ? Vector3f(along, across, -1.5F) : onWall(across, along - 1.5F);
    if (const auto normal = planes.normalAt(point)) {
      ++shared;
      const bool is_floor = normal->z() > 0.5F;
      EXPECT_LT((is_floor ? floor : wall()).distanceTo(point), kTolerance);
    } else {
      planes.add(on_floor ? floor : wall(), point);
    }
  }
  EXPECT_GT(shared, 4500);
}

}  // namespace
}  // namespace atom_map
