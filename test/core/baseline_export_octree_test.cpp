#include <octomap/OcTree.h>

#include "atom_mapping/baseline/export_octree.h"
#include "atom_mapping/baseline/octomap_baseline.h"
#include "atom_mapping/query/occupancy.h"
#include "map_file_folder.h"

namespace atom_map {
namespace {

Occupancy at(const octomap::OcTree& tree, const octomap::OcTreeKey& key) {
  const octomap::OcTreeNode* const node = tree.search(key);
  if (node == nullptr) return Occupancy::kUnknown;
  return tree.isNodeOccupied(node) ? Occupancy::kOccupied : Occupancy::kFree;
}

TEST_F(MapFile, EveryVoxelOfTheOctreeIsWhatTheMapSaysOfItsCentre) {
  for (const Eigen::Vector3d& origin : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(5000, -3000, 100)}) {
    const AtomMap drawn = drawMap(parametersOf(Mode::kOccupancy), 3000, 1);
    AtomMap map(Mode::kOccupancy, 0.25);
    map.anchor(origin);
    drawn.atoms().forEach([&](const ConstAtomRef& atom) {
      const float log_odds = atom.value();
      map.atoms().insert(atom.center(), &log_odds);
    });
    exportOctree(map, path("map.bt"));
    octomap::OcTree tree(1.0);
    ASSERT_TRUE(tree.readBinary(path("map.bt")));
    EXPECT_NEAR(tree.getResolution(), equalVolumeVoxel(0.25), 1e-5);
    Random random(2);
    std::array<int, 3> counts{};
    for (int i = 0; i < 20000; ++i) {
      const Eigen::Vector3d point =
          map.toMap(drawIn(random, {Eigen::Vector3f(-21, -16, -2), Eigen::Vector3f(21, 16, 4)}));
      const octomap::OcTreeKey key = tree.coordToKey(point.x(), point.y(), point.z());
      const Eigen::Vector3d center(tree.keyToCoord(key[0]), tree.keyToCoord(key[1]), tree.keyToCoord(key[2]));
      const Occupancy expected = classify(interpolate(map, map.toLocal(center)));
      ASSERT_EQ(at(tree, key), expected) << center.transpose();
      ++counts[static_cast<std::size_t>(expected)];
    }
    for (const int count : counts) EXPECT_GT(count, 100);
  }
}

TEST_F(MapFile, AMapFartherThanOctomapReachesIsRefused) {
  const AtomMap map = drawMap(parametersOf(Mode::kOccupancy), 10, 1);  // 100 km from the frame's origin
  EXPECT_THROW(exportOctree(map, path("map.bt")), std::runtime_error);
  EXPECT_THROW(exportOctree(AtomMap(Mode::kOccupancy, 0.25), path("none/map.bt")), std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(MapFile, AnEmptyMapIsAnEmptyOctree) {
  exportOctree(AtomMap(Mode::kOccupancy, 0.25), path("map.bt"));
  octomap::OcTree tree(1.0);
  ASSERT_TRUE(tree.readBinary(path("map.bt")));
  EXPECT_EQ(tree.size(), 0U);
}

}  // namespace
}  // namespace atom_map
