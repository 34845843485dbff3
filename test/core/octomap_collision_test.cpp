// Spheres against voxels, beside a search of all voxels.
#include <gtest/gtest.h>

#include <cmath>

#include "atom_mapping/baseline/octomap_baseline.h"
#include "draw.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

constexpr double kSide = 0.5;
constexpr int kCells = 12;  // along each axis, of which the map knows most

// Of blocks: some occupied, most free, some unknown.
OctomapBaseline makeMap(std::uint64_t seed) {
  Random random(seed);
  OctomapBaseline map(kSide);
  for (int i = 0; i < kCells * kCells * kCells; ++i) {
    const float chance = random.uniform();
    if (chance < 0.1F) continue;
    const Vector3d cell(i % kCells, i / kCells % kCells, i / kCells / kCells);
    const Vector3d center = kSide * (cell - Vector3d::Constant(0.5 * kCells - 0.5));
    map.tree().updateNode(toOctomap(center), chance > 0.95F, true);
  }
  return map;
}

// Searches every voxel that lies about the center.
bool collidesByBruteForce(const OctomapBaseline& map, const Vector3d& center, double radius, bool unknown_is_free) {
  const int reach = static_cast<int>(radius / kSide) + 2;
  for (int z = -reach; z <= reach; ++z) {
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const Vector3d cell = (center / kSide).array().floor() + Eigen::Array3d(x, y, z);
        const Vector3d voxel = kSide * (cell + Vector3d::Constant(0.5));
        const Vector3d nearest =
            center.cwiseMax(voxel - Vector3d::Constant(0.5 * kSide)).cwiseMin(voxel + Vector3d::Constant(0.5 * kSide));
        if ((nearest - center).norm() > radius) continue;
        const Occupancy state = map.classify(voxel);
        if (state == Occupancy::kOccupied || (state == Occupancy::kUnknown && !unknown_is_free)) return true;
      }
    }
  }
  return false;
}

TEST(OctomapCollision, AgreesWithASearchOfAllVoxels) {
  int collisions = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    OctomapBaseline map = makeMap(seed);
    Random random(1000 + seed);
    for (int i = 0; i < 200; ++i) {
      if (i == 100) map.tree().prune();
      const Vector3d center = drawWithin(random, 3.5F).cast<double>();
      const double radius = static_cast<double>(draw(random, 0.0F, 0.8F));
      const bool unknown_is_free = i % 2 == 0;
      const bool expected = collidesByBruteForce(map, center, radius, unknown_is_free);
      ASSERT_EQ(map.collides(center, radius, unknown_is_free), expected)
          << "seed " << seed << ", " << center.transpose() << ", " << radius << ", " << unknown_is_free;
      collisions += expected ? 1 : 0;
    }
  }
  EXPECT_GT(collisions, 1000);
  EXPECT_LT(collisions, 3500);
}

TEST(OctomapCollision, AnEmptyMapIsUnknown) {
  const OctomapBaseline map(kSide);
  EXPECT_TRUE(map.collides(Vector3d::Zero(), 0.0, false));
  EXPECT_FALSE(map.collides(Vector3d::Zero(), 1e6, true));
}

TEST(OctomapCollision, SpheresMayReachBeyondTheTree) {
  OctomapBaseline map(0.01);  // reaches to 327 m
  map.tree().updateNode(toOctomap({327.0, 0.0, 0.0}), true, true);
  EXPECT_TRUE(map.collides({400.0, 0.0, 0.0}, 73.0, true));
  EXPECT_FALSE(map.collides({400.0, 0.0, 0.0}, 72.0, true));
  EXPECT_TRUE(map.collides({400.0, 0.0, 0.0}, 0.0, false)) << "what lies outside of the tree is unknown";
}

}  // namespace
}  // namespace atom_map
