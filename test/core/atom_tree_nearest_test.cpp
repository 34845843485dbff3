// The nearest and the k nearest atoms against a walk over a plain list of the same atoms.
#include <gtest/gtest.h>

#include <algorithm>

#include "tree_under_test.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

class AtomTreeNearest : public TreeUnderTest {
 protected:
  void expectNearest(const std::vector<Neighbor>& found, const Vector3f& p, std::size_t k, float max_distance) const {
    std::vector<double> expected;
    for (const PlainAtom& atom : atoms_) expected.push_back(distance(atom.center, p));
    std::sort(expected.begin(), expected.end());
    const auto inside = [&](double margin) {
      const double limit = static_cast<double>(max_distance) * (1.0 + margin);
      const auto within = std::count_if(expected.begin(), expected.end(), [&](double d) { return d < limit; });
      return std::min(k, static_cast<std::size_t>(within));
    };
    ASSERT_GE(found.size(), inside(-kRounding));
    ASSERT_LE(found.size(), inside(kRounding));
    std::vector<float> numbers;
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_NEAR(std::sqrt(found[i].squared_distance), expected[i], kRounding * expected[i]);
      const PlainAtom& atom = atoms_.at(static_cast<std::size_t>(found[i].values[0]));
      ASSERT_EQ((PlainAtom{found[i].center, found[i].values}), atom);
      ASSERT_NEAR(distance(atom.center, p), expected[i], kRounding * expected[i]);
      ASSERT_LE(found[i == 0 ? 0 : i - 1].squared_distance, found[i].squared_distance);
      numbers.push_back(found[i].values[0]);
    }
    std::sort(numbers.begin(), numbers.end());
    ASSERT_EQ(std::adjacent_find(numbers.begin(), numbers.end()), numbers.end()) << "an atom found twice";
  }
};

TEST_P(AtomTreeNearest, AreTheNearestInTheirOrder) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Vector3f p = drawQuery(random);
    const float max_distance = drawRadius(random);
    const std::size_t k = std::array<std::size_t, 5>{0, 1, 2, 20, 100}[drawIndex(random, 5)];
    std::vector<Neighbor> found(3);  // overwritten
    tree_.kNearest(p, k, max_distance, found);
    expectNearest(found, p, k, max_distance);
    const auto nearest = tree_.nearest(p, max_distance);
    expectNearest(nearest ? std::vector<Neighbor>{*nearest} : std::vector<Neighbor>{}, p, 1, max_distance);
    const auto any = tree_.anyWithin(p, max_distance);
    ASSERT_EQ(any.has_value(), nearest.has_value());
    if (any) {
      ASSERT_LT(distance(*any, p), static_cast<double>(max_distance) * (1.0 + kRounding));
    }
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(All, AtomTreeNearest, everyDistribution(), nameOf);

}  // namespace
}  // namespace atom_map
