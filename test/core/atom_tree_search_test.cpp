// Radius and box searches of the atom tree against a walk over a plain list of the same atoms.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tree_under_test.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

class AtomTreeSearch : public TreeUnderTest {};

TEST_P(AtomTreeSearch, HoldsEveryAtomOnceWithItsValues) {
  EXPECT_EQ(tree_.size(), atoms_.size());
  EXPECT_EQ(sorted(allOf(tree_, value_count_)), sorted(atoms_));
}

TEST_P(AtomTreeSearch, RadiusFindsTheAtomsThatAreNearerAndNoOthers) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vector3f p = drawQuery(random);
    const float radius = drawRadius(random);
    std::map<PlainAtom, float> found;
    tree_.forEachWithin(p, radius, [&](ConstAtomRef atom, float squared_distance) {
      ASSERT_TRUE(found.emplace(plain(atom, value_count_), squared_distance).second) << "an atom found twice";
    });
    for (const PlainAtom& atom : atoms_) {
      const double d = distance(atom.center, p);
      const auto place = found.find(atom);
      if (place == found.end()) {
        ASSERT_GE(d, static_cast<double>(radius) * (1.0 - kRounding)) << "misses one";
        continue;
      }
      ASSERT_LT(d, static_cast<double>(radius) * (1.0 + kRounding));
      ASSERT_NEAR(std::sqrt(place->second), d, kRounding * d);
      found.erase(place);
    }
    ASSERT_TRUE(found.empty()) << "finds what is no atom";
  }
}

TEST_P(AtomTreeSearch, AStraightWayFindsTheAtomsBesideItAndNoOthers) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Vector3f from = drawQuery(random);
    const Vector3f to = i % 10 == 0 ? from : drawQuery(random);
    const float radius = drawRadius(random);
    std::vector<PlainAtom> found;
    tree_.forEachAlong(from, to, radius, [&](ConstAtomRef atom) { found.push_back(plain(atom, value_count_)); });
    std::vector<PlainAtom> surely;
    std::vector<PlainAtom> perhaps;
    const Eigen::Vector3d way = (to - from).cast<double>();
    for (const PlainAtom& atom : atoms_) {
      const Eigen::Vector3d offset = (atom.center - from).cast<double>();
      const double share = way.isZero() ? 0.0 : std::clamp(offset.dot(way) / way.squaredNorm(), 0.0, 1.0);
      const double height = (offset - share * way).norm();
      const double slack = 1e-6 * (offset.norm() + way.norm());
      if (height < static_cast<double>(radius) - slack) surely.push_back(atom);
      if (height < static_cast<double>(radius) + slack) perhaps.push_back(atom);
    }
    found = sorted(found);
    surely = sorted(surely);
    perhaps = sorted(perhaps);
    ASSERT_TRUE(std::includes(found.begin(), found.end(), surely.begin(), surely.end())) << "misses one";
    ASSERT_TRUE(std::includes(perhaps.begin(), perhaps.end(), found.begin(), found.end())) << "finds one too many";
  }
}

TEST_P(AtomTreeSearch, BoxFindsTheAtomsInItAndOnItsFaces) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    Eigen::AlignedBox3f box(drawQuery(random));
    if (i % 4 != 0) box.extend(drawQuery(random));
    if (i % 10 == 1) box.extend(Vector3f::Constant(kInfinity));
    std::vector<PlainAtom> found;
    tree_.forEachInBox(box, [&](ConstAtomRef atom) { found.push_back(plain(atom, value_count_)); });
    ASSERT_EQ(sorted(found), sorted(inBox(atoms_, box)));
  }
  int visits = 0;
  tree_.forEachInBox(Eigen::AlignedBox3f(), [&](ConstAtomRef) { ++visits; });
  EXPECT_EQ(visits, 0) << "an empty box holds nothing";
}

INSTANTIATE_TEST_SUITE_P(All, AtomTreeSearch, everyDistribution(), nameOf);

TEST(AtomTreeSearchBorder, AnAtomAtTheRadiusItselfIsOutside) {
  const AtomTree tree = makeTree(numbered(gridOnCellBorders(), 1), kCell, 1);
  std::size_t found = 0;
  tree.forEachWithin(Vector3f::Zero(), 2.0F * kCell, [&](ConstAtomRef, float) { ++found; });
  EXPECT_EQ(found, 27U) << "the 3 x 3 x 3 about the middle; the next lie at two cells";
  EXPECT_FALSE(makeTree(numbered({Vector3f::UnitX()}, 1), kCell, 1).nearest(Vector3f::Zero(), 1.0F));
}

}  // namespace
}  // namespace atom_map
