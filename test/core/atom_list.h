// Atoms in a plain list: what the atom tree must not be distinguishable from.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <tuple>
#include <vector>

#include "atom_mapping/map/atom_tree.h"

namespace atom_map {

struct PlainAtom {
  Eigen::Vector3f center;
  std::array<float, 2> values;

  auto key() const { return std::make_tuple(values[0], values[1], center.x(), center.y(), center.z()); }
  bool operator<(const PlainAtom& other) const { return key() < other.key(); }
  bool operator==(const PlainAtom& other) const { return key() == other.key(); }
};

// Atom number i of a list, with values that tell it from all others.
inline PlainAtom numbered(const Eigen::Vector3f& center, std::size_t i, int value_count) {
  const auto number = static_cast<float>(i);
  return {center, {number, value_count == 2 ? -0.5F * number : 0.0F}};
}

inline std::vector<PlainAtom> numbered(const std::vector<Eigen::Vector3f>& centers, int value_count) {
  std::vector<PlainAtom> atoms;
  for (const Eigen::Vector3f& center : centers) atoms.push_back(numbered(center, atoms.size(), value_count));
  return atoms;
}

inline PlainAtom plain(ConstAtomRef atom, int value_count) {
  return {atom.center(), {atom.value(), value_count == 2 ? atom.value(1) : 0.0F}};
}

inline std::vector<PlainAtom> sorted(std::vector<PlainAtom> atoms) {
  std::sort(atoms.begin(), atoms.end());
  return atoms;
}

inline std::vector<PlainAtom> allOf(const AtomTree& tree, int value_count) {
  std::vector<PlainAtom> atoms;
  tree.forEach([&](ConstAtomRef atom) { atoms.push_back(plain(atom, value_count)); });
  return atoms;
}

inline std::vector<PlainAtom> inBox(const std::vector<PlainAtom>& atoms, const Eigen::AlignedBox3f& box) {
  std::vector<PlainAtom> inside;
  for (const PlainAtom& atom : atoms) {
    if (box.contains(atom.center)) inside.push_back(atom);
  }
  return inside;
}

inline AtomTree makeTree(const std::vector<PlainAtom>& atoms, float cell, int value_count) {
  AtomTree tree(cell, value_count);
  for (const PlainAtom& atom : atoms) tree.insert(atom.center, atom.values.data());
  return tree;
}

// Between the single-precision coordinates, without a further rounding.
inline double distance(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return (a.cast<double>() - b.cast<double>()).norm();
}

}  // namespace atom_map
