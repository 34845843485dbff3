// Searches close after one another find what a walk over a plain list finds, while the tree grows beneath them.
#include "atom_mapping/map/vicinity.h"

#include <gtest/gtest.h>

#include "tree_under_test.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

class VicinitySearch : public TreeUnderTest {
 protected:
  std::vector<PlainAtom> found(Vicinity& vicinity, const Vector3f& p) const {
    std::vector<PlainAtom> atoms;
    vicinity.forEachWithin(p, [&](AtomRef atom, float squared_distance) {
      EXPECT_EQ(squared_distance, atom.block->squaredDistance(atom.index, p));
      atoms.push_back(plain({atom.block, atom.index}, value_count_));
    });
    return sorted(atoms);
  }

  std::vector<PlainAtom> listed(const Vector3f& p, float radius) const {
    std::vector<PlainAtom> atoms;
    tree_.forEachWithin(p, radius, [&](ConstAtomRef atom, float) { atoms.push_back(plain(atom, value_count_)); });
    return sorted(atoms);
  }
};

TEST_P(VicinitySearch, FindsWhatTheTreeFindsWhileAtomsAreInserted) {
  Random random(1);
  for (const float radius : {0.3F, 2.0F}) {
    Vicinity vicinity(tree_, radius, 4.0F * radius);
    for (int i = 0; i < 60; ++i) {
      const Vector3f middle = drawQuery(random);
      for (int k = 0; k < 5; ++k) {
        const Vector3f p = middle + drawWithin(random, 3.0F * radius);
        ASSERT_EQ(found(vicinity, p), listed(p, radius)) << "at " << p.transpose();
        const PlainAtom more = numbered(p, tree_.size(), value_count_);
        if (k % 2 == 0) vicinity.insert(more.center, more.values.data());
        ASSERT_EQ(found(vicinity, p), listed(p, radius)) << "after an insertion at " << p.transpose();
      }
    }
  }
}

TEST_P(VicinitySearch, ForgetsWhatOthersHaveRemoved) {
  Random random(2);
  Vicinity vicinity(tree_, 2.0F, 8.0F);
  for (int i = 0; i < 20; ++i) {
    const Vector3f p = drawQuery(random);
    found(vicinity, p);
    tree_.removeInBox({p - Vector3f::Constant(1.0F), p + Vector3f::Constant(1.0F)});
    vicinity.forget();
    ASSERT_EQ(found(vicinity, p), listed(p, 2.0F));
  }
}

INSTANTIATE_TEST_SUITE_P(All, VicinitySearch, everyDistribution(), nameOf);

// A leaf holds all atoms of a cell, however many, and more than are compared at once.
TEST(VicinityAtom, IsFoundInALeafThatGrowsBeyondItsCapacity) {
  AtomTree tree(kCell, 1);
  Vicinity vicinity(tree, kCell, 4.0F * kCell);
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const Vector3f center = Vector3f::Constant(0.25F * kCell) + drawWithin(random, 0.1F * kCell);
    int atoms = 0;
    vicinity.forEachWithin(center, [&](AtomRef atom, float) { atoms += atom.value() < static_cast<float>(i) ? 1 : 0; });
    ASSERT_EQ(atoms, i);
    const auto value = static_cast<float>(i);
    vicinity.insert(center, &value);
  }
  EXPECT_EQ(tree.depth(), 0U);
}

TEST(VicinityAtom, MayBeChangedWhereItIsFound) {
  AtomTree tree = makeTree(numbered(gridOnCellBorders(), 2), kCell, 2);
  Vicinity vicinity(tree, 0.1F, 0.4F);
  vicinity.forEachWithin(Vector3f::Zero(), [](AtomRef atom, float) { atom.setValue(1, 7.0F); });
  EXPECT_EQ(tree.nearest(Vector3f::Zero(), 1.0F)->values[1], 7.0F);
}

// Whoever is asked for one sign only may leave out leaves, but no atom that has or got that sign.
TEST(VicinityAtom, IsFoundByTheSignOfItsValue) {
  Random random(3);
  AtomTree tree = makeTree(numbered(gridOnCellBorders(), 1), kCell, 1);
  const auto count = [&](AtomBlock::Signs signs) {
    int atoms = 0;
    const auto visit = [&](ConstAtomRef atom, float) {
      atoms += atom.value() == 0.0F || (atom.value() > 0.0F) == (signs == AtomBlock::kNotNegative);
    };
    tree.forEachWithin(Vector3f::Zero(), 1e3F, visit, signs);
    return atoms;
  };
  for (const float share : {0.0F, 0.02F, 0.5F, 1.0F}) {
    int negative = 0;
    int positive = 0;
    Vicinity vicinity(tree, 1e3F, 1e3F);
    vicinity.forEachWithin(Vector3f::Zero(), [&](AtomRef atom, float) {
      const float value = random.uniform() < 0.1F ? 0.0F : random.uniform() < share ? -1.0F : 1.0F;
      negative += value <= 0.0F ? 1 : 0;
      positive += value >= 0.0F ? 1 : 0;
      atom.setValue(0, value);
    });
    ASSERT_EQ(count(AtomBlock::kNotPositive), negative) << share;
    ASSERT_EQ(count(AtomBlock::kNotNegative), positive) << share;
  }
}

TEST(VicinityAtom, OfASignThatNoneEverHadIsNotLookedFor) {
  const AtomTree tree = makeTree(numbered(gridOnCellBorders(), 1), kCell, 1);  // numbered from 0
  int visited = 0;
  tree.forEachWithin(
      Vector3f::Zero(), 1e3F, [&](ConstAtomRef, float) { ++visited; }, AtomBlock::kNotPositive);
  EXPECT_GE(visited, 1) << "atom 0";
  EXPECT_LE(visited, static_cast<int>(AtomTree::kLeafCapacity)) << "its leaf alone";
}

}  // namespace
}  // namespace atom_map
