// A tree made of another's atoms, in that one's order, has the same order: what map files rely on.
#include "tree_under_test.h"

namespace atom_map {
namespace {

class AtomTreeOrder : public TreeUnderTest {
 protected:
  void expectSameOrderAgain() const {
    const std::vector<PlainAtom> atoms = allOf(tree_, value_count_);
    EXPECT_EQ(allOf(makeTree(atoms, kCell, value_count_), value_count_), atoms);
  }
};

TEST_P(AtomTreeOrder, IsThatOfATreeMadeInIt) {
  expectSameOrderAgain();
}

TEST_P(AtomTreeOrder, IsThatOfATreeMadeInItAfterRemovalsToo) {
  Random random(5);
  for (int i = 0; i < 20 && tree_.size() > 0; ++i) {
    const Eigen::Vector3f a = drawIn(random, extent_);
    const Eigen::Vector3f b = a + drawWithin(random, 0.1F * extent_.diagonal().norm());
    tree_.removeInBox({a.cwiseMin(b), a.cwiseMax(b)});
    for (int n = 0; n < 5; ++n) {
      const PlainAtom atom = numbered(drawIn(random, extent_), atoms_.size() + tree_.size(), value_count_);
      tree_.insert(atom.center, atom.values.data());
    }
    expectSameOrderAgain();
  }
}

INSTANTIATE_TEST_SUITE_P(Distributions, AtomTreeOrder, everyDistribution(), nameOf);

}  // namespace
}  // namespace atom_map
