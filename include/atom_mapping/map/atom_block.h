// The bucket of one leaf of the atom tree: the atoms' coordinates and values, channel by channel in one allocation, so
// that a search reads whole cache lines and compares several atoms at once.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>

#include "atom_mapping/base/lanes.h"

namespace atom_map {

class AtomBlock {
 public:
  static constexpr std::uint32_t kMaskSize = 32;  // atoms that nearMask compares at once

  // Signs of first values; zero has both.
  enum Signs : std::uint8_t { kNotNegative = 1, kNotPositive = 2, kEverySign = kNotNegative | kNotPositive };

  explicit AtomBlock(int value_count) : value_count_(static_cast<std::uint8_t>(value_count)) {}

  std::uint32_t size() const { return size_; }
  std::uint32_t capacity() const {  // the size rounded up to whole lanes
    return (size_ + kLane - 1) / kLane * kLane;
  }

  // Channels 0, 1, 2 are x, y, z, capacity() floats each, of which the unused x are infinite; from 3 on the values, size() floats
  // each. Valid until the block changes.
  const float* channel(int c) const { return data_.get() + offset(c); }

  void setValue(std::uint32_t i, int v, float value) {
    mutableChannel(3 + v)[i] = value;
    if (v == 0) signs_ |= signsOf(value);
  }

  // Whether an atom's first value may have one of the signs: no value of a block that says no ever had, since it was made.
  bool mayHold(Signs signs) const { return (signs_ & signs) != 0; }

  Eigen::Vector3f center(std::uint32_t i) const { return {channel(0)[i], channel(1)[i], channel(2)[i]}; }

  float squaredDistance(std::uint32_t i, const Eigen::Vector3f& p) const {
    const float x = channel(0)[i] - p.x();
    const float y = channel(1)[i] - p.y();
    const float z = channel(2)[i] - p.z();
    return x * x + y * y + z * z;
  }

  // Bit i tells whether atom first + i is nearer to p than the radius, of kMaskSize atoms from `first` on, a multiple of it.
  // Without branches, four atoms at a time: most of the time of a merge is spent here.
  [[gnu::always_inline]] inline std::uint32_t nearMask(const Eigen::Vector3f& p, float squared_radius,
                                                       std::uint32_t first = 0) const;

  // The same of the straight way from `from` to `from` + `way`. `to_share`: of a point's offset from `from`, the dot product
  // with it is the point's share of the way.
  std::uint32_t nearMask(const Eigen::Vector3f& from, const Eigen::Vector3f& way, const Eigen::Vector3f& to_share,
                         float squared_radius, std::uint32_t first = 0) const;

  // Sends for the coordinates, that a search will read soon: all those of up to 26 atoms, and most of more.
  void prefetch() const {
    constexpr std::uint32_t kCacheLine = 64 / sizeof(float);
    for (std::uint32_t line = 0; line < 5; ++line) __builtin_prefetch(data_.get() + line * kCacheLine);
  }

  // Appends an atom; `values` points to value_count floats.
  void push(const Eigen::Vector3f& center, const float* values);

  // Appends a copy of the other block's atom i.
  void push(const AtomBlock& other, std::uint32_t i);

  // The last atom takes the place of atom i.
  void remove(std::uint32_t i);

  // Heap bytes held, an allocator's usual header of 8 bytes included.
  std::size_t bytes() const;

 private:
  std::size_t offset(int c) const {
    const auto channel = static_cast<std::size_t>(c);
    return c < 3 ? channel * capacity() : std::size_t{3} * capacity() + (channel - 3) * size_;
  }
  float* mutableChannel(int c) { return data_.get() + offset(c); }
  static std::uint8_t signsOf(float value) {
    return static_cast<std::uint8_t>((value >= 0.0F ? kNotNegative : 0) | (value <= 0.0F ? kNotPositive : 0));
  }
  void resize(std::uint32_t size);

  // Bit i tells what is_near(x, y, z), of a lane's coordinates, says of atom first + i.
  template <class IsNear>
  [[gnu::always_inline]] inline std::uint32_t maskOf(std::uint32_t first, const IsNear& is_near) const;

  std::unique_ptr<float[]> data_;
  std::uint32_t size_ = 0;
  std::uint8_t value_count_;
  std::uint8_t signs_ = 0;
};

template <class IsNear>
std::uint32_t AtomBlock::maskOf(std::uint32_t first, const IsNear& is_near) const {
  Bits bit{1, 2, 4, 8};
  Bits near{};
  const std::uint32_t end = std::min(capacity(), first + kMaskSize);
  for (std::uint32_t i = first; i < end; i += kLane) {
    Floats x;
    Floats y;
    Floats z;
    std::memcpy(&x, channel(0) + i, sizeof x);
    std::memcpy(&y, channel(1) + i, sizeof y);
    std::memcpy(&z, channel(2) + i, sizeof z);
    near |= is_near(x, y, z) & bit;
    bit <<= kLane;
  }
  return unionOf(near);
}

inline std::uint32_t AtomBlock::nearMask(const Eigen::Vector3f& p, float squared_radius, std::uint32_t first) const {
  return maskOf(first, [&](const Floats& x, const Floats& y, const Floats& z) -> Bits {
    const Floats dx = x - p.x();
    const Floats dy = y - p.y();
    const Floats dz = z - p.z();
    return dx * dx + dy * dy + dz * dz < squared_radius;
  });
}

inline std::uint32_t AtomBlock::nearMask(const Eigen::Vector3f& from, const Eigen::Vector3f& way,
                                         const Eigen::Vector3f& to_share, float squared_radius,
                                         std::uint32_t first) const {
  return maskOf(first, [&](const Floats& x, const Floats& y, const Floats& z) -> Bits {
    const Floats dx = x - from.x();
    const Floats dy = y - from.y();
    const Floats dz = z - from.z();
    Floats share = dx * to_share.x() + dy * to_share.y() + dz * to_share.z();
    share = share > 0.0F ? share : Floats{};
    share = share < 1.0F ? share : Floats{} + 1.0F;
    const Floats off_x = dx - share * way.x();
    const Floats off_y = dy - share * way.y();
    const Floats off_z = dz - share * way.z();
    return off_x * off_x + off_y * off_y + off_z * off_z < squared_radius;
  });
}

}  // namespace atom_map
