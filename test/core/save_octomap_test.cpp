// Files of OctoMap, read back by liboctomap.
#include "atom_mapping/baseline/save_octomap.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

#include "../test_folder.h"
#include "atom_mapping/baseline/octomap_mapper.h"
#include "simulated.h"

namespace atom_map {
namespace {

class SaveOctomap : public FolderTest {
 protected:
  void SetUp() override {
    const Drive drive = makeDrive("hall", 2);
    for (std::size_t i = 0; i < drive.scans.size(); ++i) mapper_.insertScan(drive.scans[i], drive.poses[i]);
  }

  std::string save(const std::string& name) const {
    const std::string file = path(name);
    mapper_.read([&](const OctomapBaseline& map) { saveOctomap(map.tree(), file); });
    return file;
  }

  // The file says of each voxel what the map does; `same(theirs, ours)` compares log-odds.
  template <class Same>
  void expectSame(const octomap::OcTree& file, Same same) const {
    mapper_.read([&](const OctomapBaseline& map) {
      EXPECT_EQ(file.getResolution(), map.tree().getResolution());
      std::size_t count = 0;
      for (auto leaf = map.tree().begin_leafs(); leaf != map.tree().end_leafs(); ++leaf, ++count) {
        const octomap::OcTreeNode* const node = file.search(leaf.getKey());
        ASSERT_TRUE(node != nullptr && same(node->getLogOdds(), leaf->getLogOdds()));
      }
      EXPECT_GT(count, 1000U);
    });
  }

  OctomapMapper mapper_{MappingParameters(), OctomapParameters()};
};

TEST_F(SaveOctomap, AnOtFileHoldsEveryVoxelsLogOdds) {
  const std::unique_ptr<octomap::AbstractOcTree> read(octomap::AbstractOcTree::read(save("map.ot")));
  const auto* const tree = dynamic_cast<octomap::OcTree*>(read.get());
  ASSERT_NE(tree, nullptr);
  expectSame(*tree, [](float theirs, float ours) { return theirs == ours; });
  mapper_.read([&](const OctomapBaseline& map) { EXPECT_EQ(tree->size(), map.tree().size()); });
  EXPECT_TRUE(tree->isNodeOccupied(tree->getRoot())) << "inner nodes are what their children are at most";
}

TEST_F(SaveOctomap, ABtFileHoldsFreeAndOccupied) {
  octomap::OcTree tree(1.0);
  ASSERT_TRUE(tree.readBinary(save("map.bt")));
  expectSame(tree, [](float theirs, float ours) { return (theirs < 0.0F) == (ours < 0.0F); });
}

TEST_F(SaveOctomap, SavingLeavesTheMapAsItWas) {
  const std::size_t before = mapper_.read([](const OctomapBaseline& map) { return map.tree().size(); });
  save("map.bt");
  EXPECT_EQ(mapper_.read([](const OctomapBaseline& map) { return map.tree().size(); }), before);
}

TEST_F(SaveOctomap, SaysWhatIsWrong) {
  EXPECT_THROW(save("map.ply"), std::invalid_argument);
  EXPECT_THROW(save(""), std::invalid_argument);
  EXPECT_THROW(save("none/map.ot"), std::runtime_error);
}

}  // namespace
}  // namespace atom_map
