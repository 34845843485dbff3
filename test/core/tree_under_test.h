// A tree of each distribution's atoms with one and with two values each, and queries that search it.
#pragma once

#include <gtest/gtest.h>

#include <limits>

#include "atom_list.h"
#include "distributions.h"

namespace atom_map {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kRounding = 1e-5;  // of a distance; atoms so near to a border may be on either side of it

class TreeUnderTest : public testing::TestWithParam<std::tuple<Distribution, int>> {
 protected:
  TreeUnderTest()
      : value_count_(std::get<1>(GetParam())),
        atoms_(numbered(std::get<0>(GetParam()).centers, value_count_)),
        tree_(makeTree(atoms_, kCell, value_count_)) {
    for (const PlainAtom& atom : atoms_) extent_.extend(atom.center);
    if (extent_.isEmpty()) extent_.extend(Eigen::Vector3f::Zero());
    extent_.extend(extent_.max() + Eigen::Vector3f::Constant(1.0F));
    extent_.extend(extent_.min() - Eigen::Vector3f::Constant(1.0F));
  }

  // Near the atoms, on one of them, on a cell's corner, or far from all.
  Eigen::Vector3f drawQuery(Random& random) const {
    switch (drawIndex(random, 8)) {
      case 0:
        return atoms_.empty() ? Eigen::Vector3f::Zero() : atoms_[drawIndex(random, atoms_.size())].center;
      case 1:
        return kCell * (drawIn(random, extent_) / kCell).array().round();
      case 2:
        return drawIn(random, extent_) + drawWithin(random, 2.0F * extent_.diagonal().norm());
      default:
        return drawIn(random, extent_);
    }
  }

  float drawRadius(Random& random) const {
    const float radii[] = {0.3F, kCell, 2.0F, 0.2F * extent_.diagonal().norm(), kInfinity};
    return radii[drawIndex(random, 5)];
  }

  int value_count_;
  std::vector<PlainAtom> atoms_;
  AtomTree tree_;
  Eigen::AlignedBox3f extent_;
};

inline auto everyDistribution() {
  return testing::Combine(testing::ValuesIn(distributions()), testing::Values(1, 2));
}

inline std::string nameOf(const testing::TestParamInfo<std::tuple<Distribution, int>>& instance) {
  return std::get<0>(instance.param).name + "_values_" + std::to_string(std::get<1>(instance.param));
}

}  // namespace atom_map
