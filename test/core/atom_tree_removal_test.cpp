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
    const auto end =
        std::remove_if(atoms_.begin(), atoms_.end(), [&](const PlainAtom& atom) { return box.contains(atom.center); });
    const auto removed = static_cast<std::size_t>(atoms_.end() - end);
    atoms_.erase(end, atoms_.end());
    return tree_.removeInBox(box) == removed;
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

// One step of the property: how many atoms are put in around a place, or which box is emptied.
struct Step {
  std::uint64_t seed;
  int inserted;  // 0: removes
  bool on_cell_borders;
};

rc::Gen<Step> genStep() {
  return rc::gen::build<Step>(
      rc::gen::set(&Step::seed, rc::gen::inRange<std::uint64_t>(0, 1000000)),
      rc::gen::set(&Step::inserted, rc::gen::weightedElement<int>({{3, 0}, {3, 1}, {2, 10}, {2, 100}})),
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
    const Vector3f place = drawWithin(random, 5.0F);
    for (int i = 0; i < step.inserted; ++i) {
      Vector3f center = place + drawWithin(random, 2.0F);
      if (step.on_cell_borders) center = kCell * (center / kCell).array().round();
      both.insert(center);
    }
    RC_ASSERT(both.agree());
    RC_ASSERT(both.nearestAgree(place));
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

INSTANTIATE_TEST_SUITE_P(All, AtomTreeRemovals, testing::ValuesIn(distributions()),
                         [](const auto& instance) { return instance.param.name; });

TEST(AtomTreeRemoval, AnEmptyBoxRemovesNothing) {
  AtomTree tree = makeTree(numbered(gridOnCellBorders(), 1), kCell, 1);
  EXPECT_EQ(tree.removeInBox(AlignedBox3f()), 0U);
  EXPECT_EQ(tree.removeInBox(AlignedBox3f(Vector3f(0.1F, 0.1F, 0.1F), Vector3f(0.4F, 0.4F, 0.4F))), 0U);
  EXPECT_EQ(tree.size(), 2197U);
}

}  // namespace
}  // namespace atom_map
