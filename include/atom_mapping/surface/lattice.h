// Points of a cubic lattice where a field was evaluated, and the cells between them: what marching cubes works on.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "atom_mapping/base/random.h"

namespace atom_map {

using LatticeIndex = Eigen::Vector3i;

struct HashLatticeIndex {
  std::size_t operator()(const LatticeIndex& i) const {
    const auto word = [](int v) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v)); };
    return static_cast<std::size_t>(mixBits(mixBits(word(i.x()) << 32 | word(i.y())) + word(i.z())));
  }
};

// The lower corner names a cell. `corners` are numbers of nodes, in VTK's order of a hexahedron.
struct LatticeCell {
  LatticeIndex index;
  std::array<std::uint32_t, 8> corners;
};

// Nodes that were asked for, numbered in the order of asking.
class Lattice {
 public:
  explicit Lattice(float spacing) : spacing_(spacing) {}

  Eigen::Vector3f position(std::uint32_t node) const { return spacing_ * nodes_[node].cast<float>(); }
  Eigen::Vector3f center(const LatticeIndex& cell) const {
    return spacing_ * (cell.cast<float>() + Eigen::Vector3f::Constant(0.5F));
  }
  LatticeIndex cellOf(const Eigen::Vector3f& point) const {
    return (point / spacing_).array().floor().matrix().cast<int>();
  }
  std::size_t size() const { return nodes_.size(); }

  // Adds the corners that are missing.
  LatticeCell cell(const LatticeIndex& index) {
    static const std::array<LatticeIndex, 8> kOffsets{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
    LatticeCell cell{index, {}};
    for (std::size_t i = 0; i < 8; ++i) cell.corners[i] = node(index + kOffsets[i]);
    return cell;
  }

 private:
  std::uint32_t node(const LatticeIndex& index) {
    const auto [entry, is_new] = numbers_.try_emplace(index, static_cast<std::uint32_t>(nodes_.size()));
    if (is_new) nodes_.push_back(index);
    return entry->second;
  }

  float spacing_;
  std::vector<LatticeIndex> nodes_;
  std::unordered_map<LatticeIndex, std::uint32_t, HashLatticeIndex> numbers_;
};

}  // namespace atom_map
