// How the planes of AtomTree lie to what is searched for.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace atom_map {

// Of a coordinate or of the difference of two near it, with two roundings to spare.
constexpr float kTreeRounding = 4e-7F;

// From a point to the box that a child's way through the planes leaves.
struct GapToBox {
  std::array<float, 3> squared_along{};  // m^2, of each axis
  float squared = 0.0F;

  // To the part of the box that begins at that offset along an axis, which must be farther than it began.
  float squaredBeyond(int axis, float offset) const {
    return squared + (offset * offset - squared_along[static_cast<std::size_t>(axis)]);
  }
  GapToBox beyond(int axis, float offset) const {
    GapToBox gap = *this;
    gap.squared = squaredBeyond(axis, offset);
    gap.squared_along[static_cast<std::size_t>(axis)] = offset * offset;
    return gap;
  }
};

// A straight way, as the planes across each axis cut it: by shares of the way.
struct CutWay {
  struct Axis {
    float start;  // m
    float shares_per_metre;
    float reach;  // the radius and the rounding, in shares
  };
  std::array<Axis, 3> axes;

  // `radius` in metres.
  CutWay(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius);
};

}  // namespace atom_map
