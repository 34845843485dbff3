// Which returns share the normal of a plane that was fitted to others.
#include "atom_mapping/scan/shared_planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "atom_mapping/scan/estimate_normal.h"
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

// A plane through a place near the origin, seen from it, that some fits agree on.
Patch drawPatch(Random& random) {
  const Vector3f normal = drawDirection(random);
  return {normal, normal.dot(drawWithin(random, 2.0F)), 1 + static_cast<int>(drawIndex(random, 5))};
}

// The nearest by its distance that a return may lie on, plane by plane.
const Patch* nearestByHand(const std::vector<Patch>& planes, const Vector3f& point, float tolerance, int least_fits) {
  const Patch* nearest = nullptr;
  for (const Patch& plane : planes) {
    const float facing = plane.normal.dot(-point) / point.norm();
    if (plane.fits < least_fits || facing <= kMinFacing || plane.distanceTo(point) >= tolerance) continue;
    tolerance = plane.distanceTo(point);
    nearest = &plane;
  }
  return nearest;
}

TEST(Patches, FindTheNearestPlaneThatAReturnMayLieOn) {
  Random random(3);
  int found = 0;
  for (int cell = 0; cell < 300; ++cell) {
    Patches patches;
    std::vector<Patch> planes;
    for (std::size_t i = drawIndex(random, Patches::kMost + 1); i > 0; --i) {
      planes.push_back(drawPatch(random));
      patches.add(planes.back());
    }
    ASSERT_EQ(patches.size(), planes.size());
    for (int i = 0; i < 50; ++i) {
      const Vector3f point = drawWithin(random, 3.0F);
      const int least_fits = 1 + i % 4;
      const auto number = patches.find(point, Vector3f::Zero(), 0.3F, least_fits);
      const Patch* const nearest = nearestByHand(planes, point, 0.3F, least_fits);
      ASSERT_EQ(number.has_value(), nearest != nullptr);
      if (!number) continue;
      EXPECT_EQ(patches[*number].normal, nearest->normal);
      EXPECT_EQ(patches[*number].level, nearest->level);
      ++found;
    }
  }
  EXPECT_GT(found, 1000);
}

TEST(Patches, OfMoreThanACellHoldsTheLatestAreDropped) {
  Patches patches;
  for (int i = 0; i < 20; ++i) patches.add({Vector3f::UnitZ(), static_cast<float>(i)});
  ASSERT_EQ(patches.size(), Patches::kMost);
  for (std::uint32_t i = 0; i < patches.size(); ++i) EXPECT_EQ(patches[i].level, static_cast<float>(i));
}

// However far from the origin of the frame: two planes through a place, a degree or two apart.
TEST(Patches, AJoinedPlaneGoesThroughThePlaceOfBoth) {
  for (const float far : {0.0F, 100.0F, 1000.0F, 5000.0F}) {
    const Vector3f place(-far, 0.3F, 0.2F);
    Patches patches;
    for (const float turn : {-0.01F, 0.01F}) {
      const Vector3f normal = wall(turn).normal;
      patches.join({normal, normal.dot(place)}, place, kTolerance);
    }
    ASSERT_EQ(patches.size(), 1U) << far;
    EXPECT_EQ(patches[0].fits, 2);
    EXPECT_LT(patches[0].distanceTo(place), 1e-3F + 1e-6F * far) << far;
  }
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
