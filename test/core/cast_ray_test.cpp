#include "atom_mapping/query/cast_ray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "atom_mapping/base/random.h"
#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr float kRadius = 0.5F;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

void add(AtomMap& map, const Vector3f& center, float value) {
  map.atoms().insert(center, &value);
}

// A corridor of tangent free atoms along x, from x = 0 to length - 1.
AtomMap makeCorridor(int length) {
  AtomMap map(Mode::kOccupancy, kRadius);
  for (int x = 0; x < length; ++x) add(map, Vector3f(x, 0.0F, 0.0F), -1.0F);
  return map;
}

Occupancy ask(const AtomMap& map, const Vector3f& point) {
  return classify(interpolate(map, point));
}

TEST(CastRay, FreeSpaceUpToTheRangeIsAMiss) {
  const AtomMap map = makeCorridor(20);
  const CastRay ray = castRay(map, Vector3f::Zero(), Vector3f::UnitX(), 12.3F);
  EXPECT_EQ(ray.end, RayEnd::kMiss);
  EXPECT_EQ(ray.distance, 12.3F);
}

TEST(CastRay, HitsHalfwayBetweenAFreeAtomAndAnEquallySureOccupiedOne) {
  AtomMap map = makeCorridor(10);
  add(map, Vector3f(10.0F, 0.0F, 0.0F), 1.0F);
  const CastRay ray = castRay(map, Vector3f::Zero(), Vector3f::UnitX(), 100.0F);
  EXPECT_EQ(ray.end, RayEnd::kHit);
  EXPECT_NEAR(ray.distance, 9.5F, 0.01F * kRadius);
}

TEST(CastRay, EndsWhereItEntersUnknownSpace) {
  const AtomMap map = makeCorridor(10);
  const CastRay ray = castRay(map, Vector3f::Zero(), Vector3f::UnitX(), kInfinity);
  EXPECT_EQ(ray.end, RayEnd::kUnknown);
  EXPECT_NEAR(ray.distance, 10.0F, 0.01F * kRadius);  // 2r beyond the last centre
}

TEST(CastRay, WhatLiesBehindUnknownSpaceIsNotSeen) {
  AtomMap map = makeCorridor(10);
  add(map, Vector3f(14.0F, 0.0F, 0.0F), 1.0F);
  EXPECT_EQ(castRay(map, Vector3f::Zero(), Vector3f::UnitX(), 100.0F).end, RayEnd::kUnknown);
}

TEST(CastRay, TheOriginItselfMayBeUnknownOrOccupied) {
  AtomMap map = makeCorridor(10);
  add(map, Vector3f(10.0F, 0.0F, 0.0F), 1.0F);
  const CastRay unknown = castRay(map, Vector3f(0.0F, 0.0F, 5.0F), Vector3f::UnitX(), 100.0F);
  EXPECT_EQ(unknown.end, RayEnd::kUnknown);
  EXPECT_EQ(unknown.distance, 0.0F);
  const CastRay occupied = castRay(map, Vector3f(10.0F, 0.0F, 0.0F), Vector3f::UnitX(), 100.0F);
  EXPECT_EQ(occupied.end, RayEnd::kHit);
  EXPECT_EQ(occupied.distance, 0.0F);
}

TEST(CastRay, ARangeOfZeroAsksForTheOriginOnly) {
  const AtomMap map = makeCorridor(10);
  EXPECT_EQ(castRay(map, Vector3f(3.0F, 0.0F, 0.0F), Vector3f::UnitX(), 0.0F).end, RayEnd::kMiss);
  EXPECT_EQ(castRay(map, Vector3f(3.0F, 0.0F, 3.0F), Vector3f::UnitX(), 0.0F).end, RayEnd::kUnknown);
}

TEST(CastRay, AnObstacleJustBeyondTheRangeIsNotHit) {
  AtomMap map = makeCorridor(10);
  add(map, Vector3f(10.0F, 0.0F, 0.0F), 1.0F);
  EXPECT_EQ(castRay(map, Vector3f::Zero(), Vector3f::UnitX(), 9.49F).end, RayEnd::kMiss);
  EXPECT_EQ(castRay(map, Vector3f::Zero(), Vector3f::UnitX(), 9.51F).end, RayEnd::kHit);
}

// Marches in steps of a hundredth of a radius, by the definition.
CastRay castByForce(const AtomMap& map, const Vector3f& origin, const Vector3f& direction, float max_range) {
  for (int i = 0;; ++i) {
    const float distance = 0.01F * kRadius * static_cast<float>(i);
    if (distance > max_range) return {RayEnd::kMiss, max_range};
    const Occupancy there = ask(map, origin + distance * direction);
    if (there == Occupancy::kOccupied) return {RayEnd::kHit, distance};
    if (there == Occupancy::kUnknown) return {RayEnd::kUnknown, distance};
  }
}

// What a coarser step may pass over are rims, narrower than the step itself.
TEST(CastRay, AgreesWithBruteForceSaveForWhatIsThinnerThanAStep) {
  Random random(7);
  const auto draw = [&](float half) { return half * (2.0F * random.uniform() - 1.0F); };
  AtomMap map(Mode::kOccupancy, kRadius);
  for (int i = 0; i < 60000; ++i) {
    const Vector3f center(draw(8.0F), draw(8.0F), draw(8.0F));
    if (map.atoms().nearest(center, 2.0F * kRadius)) continue;
    add(map, center, random.uniform() < 0.05F ? 1.0F : -1.0F);
  }
  int agree = 0;
  int hits = 0;
  constexpr int kRays = 1000;
  for (int i = 0; i < kRays; ++i) {
    const Vector3f origin(draw(5.0F), draw(5.0F), draw(5.0F));
    const Vector3f direction = Vector3f(draw(1.0F), draw(1.0F), draw(1.0F)).normalized();
    const CastRay ray = castRay(map, origin, direction, 10.0F);
    const CastRay truth = castByForce(map, origin, direction, 10.0F);
    ASSERT_GE(ray.distance, truth.distance - 0.011F * kRadius);
    const Vector3f end = origin + ray.distance * direction;
    ASSERT_EQ(ask(map, end) == Occupancy::kOccupied, ray.end == RayEnd::kHit);
    ASSERT_EQ(ask(map, end) == Occupancy::kUnknown, ray.end == RayEnd::kUnknown);
    agree += ray.end == truth.end && std::abs(ray.distance - truth.distance) < 0.021F * kRadius ? 1 : 0;
    hits += ray.end == RayEnd::kHit ? 1 : 0;
  }
  EXPECT_GT(hits, 200);
  EXPECT_GE(agree, kRays * 9 / 10);
}

}  // namespace
}  // namespace atom_map
