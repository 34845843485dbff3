// The planes of one cell, on which returns may lie.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "atom_mapping/scan/estimate_normal.h"
#include "atom_mapping/scan/shared_planes.h"
#include "draw.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

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
      const Vector3f normal(-std::cos(turn), -std::sin(turn), 0.0F);
      patches.join({normal, normal.dot(place)}, place, 0.05F);
    }
    ASSERT_EQ(patches.size(), 1U) << far;
    EXPECT_EQ(patches[0].fits, 2);
    EXPECT_LT(patches[0].distanceTo(place), 1e-3F + 1e-6F * far) << far;
  }
}

}  // namespace
}  // namespace atom_map
