// Removal from the atom tree, and removals among insertions, against a plain list of the same atoms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "atom_list.h"
#include "distributions.h"
#include "reproducible.h"

namespace atom_map {
namespace {

using Eigen::AlignedBox3f;
using Eigen::Vector3f;

// What a tree and a list do alike.
class TreeAndList {
 public:
  explicit TreeAndList(int value_count) : value_count_(value_count), tree_(kCell, value_count) {}

  void insert(const Vector3f& center) {
    atoms_.push_back(numbered(center, inserted_++, value_count_));
    tree_.insert(center, atoms_.back().values.data());
  }

  // Whether both say that they removed as many.
  bool removeInBox(const AlignedBox3f& box) {
    return removeFromList([&](const Vector3f& center) { return box.contains(center); }) == tree_.removeInBox(box);
  }

  // In slices, each of which must end soon after `at_most`.
  bool removeBeyond(const Vector3f& p, float radius, std::size_t at_most) {
    const std::size_t expected =
        removeFromList([&](const Vector3f& center) { return !((center - p).squaredNorm() < radius * radius); });
    std::size_t removed = 0;
    for (;;) {
      const std::size_t slice = tree_.removeBeyond(p, radius, at_most);
      removed += slice;
      if (slice < at_most) return removed == expected;
      if (slice >= at_most + kLongestLeaf) return false;
    }
  }

  // Whether the tree is the one that its atoms make when they are inserted in its order, leaf by leaf.
  bool isAsIfInsertedInItsOrder() const {
    AtomTree again(kCell, value_count_);
    for (const PlainAtom& atom : allOf(tree_, value_count_)) again.insert(atom.center, atom.values.data());
    return leafSizes(again) == leafSizes(tree_) && allOf(again, value_count_) == allOf(tree_, value_count_);
  }

  bool agree() const { return tree_.size() == atoms_.size() && sorted(allOf(tree_, value_count_)) == sorted(atoms_); }

  bool nearestAgree(const Vector3f& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const PlainAtom& atom : atoms_) least = std::min(least, distance(atom.center, p));
    const auto found = tree_.nearest(p, std::numeric_limits<float>::infinity());
    return found.has_value() != atoms_.empty() &&
           (!found || std::abs(distance(found->center, p) - least) <= 1e-5 * least);
  }

  const AtomTree& tree() const { return tree_; }
  const std::vector<PlainAtom>& atoms() const { return atoms_; }

 private:
  static constexpr std::size_t kLongestLeaf = 100;  // of the distributions, with their duplicates

  template <class IsGone>
  std::size_t removeFromList(IsGone&& is_gone) {
    const auto end =
        std::remove_if(atoms_.begin(), atoms_.end(), [&](const auto& atom) { return is_gone(atom.center); });
    const auto removed = static_cast<std::size_t>(atoms_.end() - end);
    atoms_.erase(end, atoms_.end());
    return removed;
  }

  static std::vector<std::uint32_t> leafSizes(const AtomTree& tree) {
    std::vector<std::uint32_t> sizes;
    tree.forEachBlock([&](const AtomBlock& block) { sizes.push_back(block.size()); });
    return sizes;
  }

  int value_count_;
  AtomTree tree_;
  std::vector<PlainAtom> atoms_;
  std::size_t inserted_ = 0;
};

AlignedBox3f drawBox(Random& random, float half, float reach) {
  const Vector3f middle = drawWithin(random, half);
  const Vector3f size = drawWithin(random, reach).cwiseAbs();
  return {middle - size, middle + size};
}

// One step of the property: how many atoms are put in around a place, or which box is emptied, or what lies beyond a ball.
struct Step {
  std::uint64_t seed;
  int inserted;  // 0: removes a box, -1: beyond a ball
  bool on_cell_borders;
};

rc::Gen<Step> genStep() {
  return rc::gen::build<Step>(
      rc::gen::set(&Step::seed, rc::gen::inRange<std::uint64_t>(0, 1000000)),
      rc::gen::set(&Step::inserted, rc::gen::weightedElement<int>({{3, 0}, {1, -1}, {3, 1}, {2, 10}, {2, 100}})),
      rc::gen::set(&Step::on_cell_borders, rc::gen::arbitrary<bool>()));
}

void showValue(const Step& step, std::ostream& out) {
  out << (step.inserted > 0 ? "insert " + std::to_string(step.inserted) : "remove") << " seed " << step.seed
      << (step.on_cell_borders ? " on borders" : "");
}

RC_GTEST_PROP(AtomTreeRemoval, AnyInterleavingWithInsertionLeavesWhatAListWouldHold, ()) {
  TreeAndList both(*rc::gen::inRange(1, 3));
  for (const Step& step : *rc::gen::container<std::vector<Step>>(genStep())) {
    Random random(step.seed);
    if (step.inserted == 0) RC_ASSERT(both.removeInBox(drawBox(random, 6.0F, 5.0F)));
    if (step.inserted < 0) {
      const Vector3f middle = drawWithin(random, 4.0F);
      RC_ASSERT(both.removeBeyond(middle, draw(random, 0.0F, 10.0F), 1 + drawIndex(random, 200)));
    }
    const Vector3f place = drawWithin(random, 5.0F);
    for (int i = 0; i < step.inserted; ++i) {
      Vector3f center = place + drawWithin(random, 2.0F);
      if (step.on_cell_borders) center = kCell * (center / kCell).array().round();
      both.insert(center);
    }
    RC_ASSERT(both.agree());
    RC_ASSERT(both.nearestAgree(place));
    RC_ASSERT(both.isAsIfInsertedInItsOrder());
  }
}

class AtomTreeRemovals : public testing::TestWithParam<Distribution> {};

TEST_P(AtomTreeRemovals, BoxByBoxLeavesTheAtomsOutside) {
  for (const int value_count : {1, 2}) {
    TreeAndList both(value_count);
    for (const Vector3f& center : GetParam().centers) both.insert(center);
    ASSERT_TRUE(both.agree());
    Random random(4);
    while (!both.atoms().empty()) {  // around one of the atoms, so that every round removes some
      const Vector3f middle = both.atoms()[drawIndex(random, both.atoms().size())].center;
      const Vector3f size = drawWithin(random, 20.0F).cwiseAbs();
      ASSERT_TRUE(both.removeInBox({middle - size, middle + size}));
      ASSERT_TRUE(both.agree());
      ASSERT_TRUE(both.nearestAgree(middle));
    }
    EXPECT_EQ(both.tree().size(), 0U);
    EXPECT_EQ(both.tree().depth(), 0U);
    EXPECT_EQ(both.tree().bytes(), 0U);
  }
}

TEST_P(AtomTreeRemovals, BallByBallLeavesTheAtomsWithin) {
  for (const int value_count : {1, 2}) {
    TreeAndList both(value_count);
    for (const Vector3f& center : GetParam().centers) both.insert(center);
    Random random(5);
    float reach = 2000.0F;
    while (!both.atoms().empty()) {  // about one of the atoms, smaller and smaller
      const Vector3f middle = both.atoms()[drawIndex(random, both.atoms().size())].center + drawWithin(random, 1.0F);
      ASSERT_TRUE(both.removeBeyond(middle, reach, 1 + drawIndex(random, 300)));
      ASSERT_TRUE(both.agree());
      ASSERT_TRUE(both.nearestAgree(middle));
      ASSERT_TRUE(both.isAsIfInsertedInItsOrder());
      reach = reach < 0.1F ? 0.0F : 0.6F * reach;
    }
    EXPECT_EQ(both.tree().bytes(), 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(All, AtomTreeRemovals, testing::ValuesIn(distributions()),
                         [](const auto& instance) { return instance.param.name; });

TEST(AtomTreeRemoval, BeyondARadiusIsWhatASearchWithinDoesNotVisit) {
  AtomTree tree = makeTree(numbered(gridOnCellBorders(), 1), kCell, 1);
  std::size_t within = 0;
  tree.forEachWithin(Vector3f::Zero(), 2.0F, [&](ConstAtomRef, float) { ++within; });  // many lie just so far
  tree.removeBeyond(Vector3f::Zero(), 2.0F);
  EXPECT_EQ(tree.size(), within);
  EXPECT_EQ(tree.removeBeyond(Vector3f::Zero(), std::numeric_limits<float>::infinity()), 0U);
  EXPECT_EQ(tree.removeBeyond(Vector3f::Zero(), 0.0F), within);
}

TEST(AtomTreeRemoval, AnEmptyBoxRemovesNothing) {
  AtomTree tree = makeTree(numbered(gridOnCellBorders(), 1), kCell, 1);
  EXPECT_EQ(tree.removeInBox(AlignedBox3f()), 0U);
  EXPECT_EQ(tree.removeInBox(AlignedBox3f(Vector3f(0.1F, 0.1F, 0.1F), Vector3f(0.4F, 0.4F, 0.4F))), 0U);
  EXPECT_EQ(tree.size(), 2197U);
}

}  // namespace
}  // namespace atom_map
