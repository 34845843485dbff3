// No order of arrival and no lie of the atoms degenerates the tree.
#include <gtest/gtest.h>

#include <cmath>

#include "atom_list.h"
#include "atom_orders.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;
using LeafContents = std::vector<std::vector<PlainAtom>>;  // leaf by leaf in the tree's order, atoms sorted

AtomTree makeTree(const Centers& centers) {
  return makeTree(numbered(centers, 1), kCell, 1);
}

LeafContents leavesOf(const AtomTree& tree) {
  LeafContents leaves;
  const AtomBlock* block = nullptr;
  tree.forEach([&](ConstAtomRef atom) {
    if (atom.block != block) leaves.emplace_back();
    block = atom.block;
    leaves.back().push_back(plain(atom, 1));
  });
  for (auto& leaf : leaves) leaf = sorted(std::move(leaf));
  return leaves;
}

int cellsAlongLongestSide(const Centers& centers) {
  Eigen::AlignedBox3f extent;
  for (const Vector3f& center : centers) extent.extend(center);
  return static_cast<int>(std::ceil(extent.sizes().maxCoeff() / kCell)) + 1;
}

class AtomTreeShape : public testing::TestWithParam<Distribution> {
 protected:
  const Centers& centers() const { return GetParam().centers; }
};

TEST_P(AtomTreeShape, AtomsOfTheTestDoNotOverlap) {
  const AtomTree tree = makeTree(centers());
  for (const Vector3f& center : centers()) {
    int near = 0;
    tree.forEachWithin(center, 0.99F * kDiameter, [&](ConstAtomRef, float) { ++near; });
    ASSERT_EQ(near, 1);
  }
}

TEST_P(AtomTreeShape, DepthIsLogarithmic) {
  const AtomTree tree = makeTree(centers());
  const auto leaves = static_cast<double>(leavesOf(tree).size());
  EXPECT_LE(static_cast<double>(tree.depth()), 3.0 * std::log2(cellsAlongLongestSide(centers())) + 1.0);
  EXPECT_LE(static_cast<double>(tree.depth()), 1.5 * std::log2(leaves) + 1.0) << leaves << " leaves";
}

TEST_P(AtomTreeShape, LeavesAreWellFilled) {
  const LeafContents leaves = leavesOf(makeTree(centers()));
  for (const auto& leaf : leaves) ASSERT_LE(leaf.size(), AtomTree::kLeafCapacity);
  EXPECT_GE(centers().size() / leaves.size(), AtomTree::kLeafCapacity / 4);
}

TEST_P(AtomTreeShape, DoesNotDependOnTheOrderOfInsertion) {
  const LeafContents leaves = leavesOf(makeTree(centers()));
  std::vector<PlainAtom> atoms = numbered(centers(), 1);
  Random random(7);
  for (std::size_t i = atoms.size(); i > 1; --i) std::swap(atoms[i - 1], atoms[drawIndex(random, i)]);
  EXPECT_EQ(leavesOf(makeTree(atoms, kCell, 1)), leaves);
}

INSTANTIATE_TEST_SUITE_P(Orders, AtomTreeShape, testing::ValuesIn(robotOrders()),
                         [](const auto& instance) { return instance.param.name; });

TEST(AtomTreeShapeBound, DepthHoldsWhereEveryCellIsOverfull) {
  for (const int low : {-1, 0, 3, -8, 13}) {
    for (const int cells : {1, 2, 5, 9}) {
      Centers centers;
      for (int x = 0; x < cells; ++x) {
        for (int y = 0; y < cells; ++y) {
          const Vector3f cell(static_cast<float>(low + x), static_cast<float>(low + y), static_cast<float>(low));
          centers.insert(centers.end(), AtomTree::kLeafCapacity + 1, kCell * (cell + Vector3f::Constant(0.5F)));
        }
      }
      EXPECT_LE(makeTree(centers).depth(), 2 * (static_cast<std::size_t>(std::ceil(std::log2(cells))) + 1));
    }
  }
}

TEST(AtomTreeShapeBound, CoordinatesBeyondAllCellsStayFindable) {
  Centers centers;
  for (float x = 1e-3F; x < 1e30F; x *= 3.0F) {
    for (const float sign : {-1.0F, 1.0F}) centers.emplace_back(sign * x, 0.0F, -sign * x);
  }
  const AtomTree tree = makeTree(centers);
  EXPECT_LE(tree.depth(), 96U);
  for (const Vector3f& center : centers) {
    const auto found = tree.nearest(center, 1.0F);
    ASSERT_TRUE(found) << center.transpose();
    EXPECT_EQ(found->center, center);
  }
}

}  // namespace
}  // namespace atom_map
