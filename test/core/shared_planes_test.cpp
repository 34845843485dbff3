// Which returns share the normal of a plane that was fitted to others.
#include "atom_mapping/scan/shared_planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "draw.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr float kCell = 1.0F;        // m; a wide one has 8 m
constexpr float kTolerance = 0.05F;  // m

// A wall three metres before the origin, square to x but for a turn about z (radians).
Patch wall(float turn = 0.0F) {
  return {Vector3f(-std::cos(turn), -std::sin(turn), 0.0F), -3.0F * std::cos(turn)};
}

Vector3f onWall(float y, float z) {
  return {3.0F, y, z};
}

SharedPlanes seenFromOrigin(const std::vector<KnownPlane>& known = {}) {
  return {kCell, kTolerance, Vector3f::Zero(), 100, known};
}

// A scan in which three fits to the wide cell at the origin agreed on the wall.
SharedPlanes whereTheWallIsSure() {
  SharedPlanes planes = seenFromOrigin();
  for (const float turn : {-0.01F, 0.0F, 0.01F}) planes.add(wall(turn), onWall(0.5F + 100.0F * (turn + 0.01F), 0.5F));
  return planes;
}

TEST(SharedPlanes, AReturnOfTheSameCellSharesOneThatItLiesOn) {
  SharedPlanes planes = seenFromOrigin();
  EXPECT_FALSE(planes.normalAt(onWall(0.1F, 0.1F)));
  planes.add(wall(), onWall(0.1F, 0.1F));
  EXPECT_EQ(planes.normalAt(onWall(0.9F, 0.9F)), wall().normal);
  EXPECT_EQ(planes.normalAt({3.04F, 0.5F, 0.5F}), wall().normal);
  EXPECT_FALSE(planes.normalAt({3.06F, 0.5F, 0.5F})) << "beyond the tolerance";
  EXPECT_FALSE(planes.normalAt(onWall(1.1F, 0.5F))) << "the next cell";
}

TEST(SharedPlanes, AReturnOfAWideCellSharesOneThatThreeFitsAgreeOn) {
  SharedPlanes planes = seenFromOrigin();
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

TEST(SharedPlanes, ThoseThatAreSureAndSeenServeTheNextScanFromWhereverItIsTaken) {
  const std::vector<KnownPlane> known = whereTheWallIsSure().known();
  ASSERT_EQ(known.size(), 1U);
  for (const float x : {2.0F, 0.0F, -5.0F}) {
    SharedPlanes next(kCell, kTolerance, {x, 1.0F, 1.0F}, 100, known);
    EXPECT_TRUE(next.normalAt(onWall(5.5F, 5.5F))) << "from x = " << x;
  }
  SharedPlanes behind(kCell, kTolerance, {5.0F, 1.0F, 1.0F}, 100, known);
  EXPECT_FALSE(behind.normalAt(onWall(5.5F, 5.5F))) << "its other side is another plane";
}

TEST(SharedPlanes, WhatNoReturnOfAScanLiesOnIsForgotten) {
  SharedPlanes next = seenFromOrigin(whereTheWallIsSure().known());
  EXPECT_FALSE(next.normalAt({1.0F, 1.0F, 1.0F}));
  EXPECT_TRUE(next.known().empty());
}

TEST(SharedPlanes, FitsThatFewAgreeOnAreForgotten) {
  SharedPlanes planes = seenFromOrigin();
  planes.add(wall(), onWall(0.5F, 0.5F));
  planes.add(wall(), onWall(0.6F, 0.5F));
  EXPECT_TRUE(planes.normalAt(onWall(0.7F, 0.5F)));
  EXPECT_TRUE(planes.known().empty());
}

// A known plane that is a degree off: by the fits that are asked for now and then it comes true over the scans.
TEST(SharedPlanes, KnownPlanesGrowTruer) {
  constexpr float kOff = 0.0175F;
  SharedPlanes first = seenFromOrigin();
  for (int i = 0; i < 3; ++i) first.add(wall(kOff), onWall(0.0F, 0.5F + static_cast<float>(i)));
  std::vector<KnownPlane> known = first.known();
  ASSERT_EQ(known.size(), 1U);
  int fits = 0;
  int returns = 0;
  for (int scan = 0; scan < 40; ++scan) {
    SharedPlanes planes = seenFromOrigin(known);
    for (int i = 0; i < 200; ++i, ++returns) {
      const Vector3f point = onWall(0.01F * static_cast<float>(i), 0.5F);
      if (planes.normalAt(point)) continue;
      planes.add(wall(), point);
      ++fits;
    }
    known = planes.known();
    ASSERT_EQ(known.size(), 1U) << "scan " << scan;
  }
  EXPECT_LT(fits, returns / 40) << "hardly any are fitted again";
  EXPECT_LT((known[0].normal - wall().normal).norm(), 0.1F * kOff);
}

// A door that turned by 30 degrees, of which some returns still lie on the plane where it was: not for long.
TEST(SharedPlanes, AKnownPlaneThatHasTurnedIsForgotten) {
  std::vector<KnownPlane> known = whereTheWallIsSure().known();
  int scans = 0;
  for (; !known.empty() && scans < 100; ++scans) {
    SharedPlanes planes = seenFromOrigin(known);
    for (int i = 0; i < 200; ++i) {
      const Vector3f point = onWall(0.01F * static_cast<float>(i), 0.5F);
      if (!planes.normalAt(point)) planes.add({wall(0.5F).normal, wall(0.5F).normal.dot(point)}, point);
    }
    known = planes.known();
    if (known.size() == 1 && known[0].normal.dot(wall(0.5F).normal) > 0.999F) break;
  }
  EXPECT_LT(scans, 10);
}

TEST(SharedPlanes, FitsToACurvedSurfaceDoNotAgree) {
  SharedPlanes planes = seenFromOrigin();
  for (int i = 0; i < 20; ++i) {  // a column of 2 m, 5 m away, every three degrees
    const float angle = static_cast<float>(i - 10) * 0.0524F;
    const Vector3f normal(-std::cos(angle), std::sin(angle), 0.0F);
    const Vector3f point = Vector3f(5.0F, 0.0F, 0.5F) + 2.0F * normal;
    planes.add({normal, normal.dot(point)}, point);
    EXPECT_FALSE(planes.normalAt(point + Vector3f::UnitZ())) << i;
  }
  EXPECT_TRUE(planes.known().empty());
}

// Floor and wall: wherever the fits came from, a shared normal is that of a plane within the tolerance that faces the sensor.
TEST(SharedPlanes, AReturnLiesOnThePlaneWhoseNormalItShares) {
  Random random(1);
  const Patch floor{Vector3f::UnitZ(), -1.5F};
  std::vector<KnownPlane> known;
  for (int scan = 0; scan < 5; ++scan) {
    SharedPlanes planes = seenFromOrigin(known);
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
    known = planes.known();
  }
}

}  // namespace
}  // namespace atom_map
