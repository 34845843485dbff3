// The bucket of one leaf of the atom tree: the atoms' coordinates and values, channel by channel in one allocation, so
// that a search reads whole cache lines and compares several atoms at once.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>

namespace atom_map {

class AtomBlock {
 public:
  static constexpr std::uint32_t kLane = 4;  // atoms; a block's capacity is its size rounded up to a whole lane

  using Lane = Eigen::Array<float, kLane, 1>;

  explicit AtomBlock(int value_count) : value_count_(static_cast<std::uint8_t>(value_count)) {}

  std::uint32_t size() const { return size_; }
  std::uint32_t capacity() const { return (size_ + kLane - 1) / kLane * kLane; }

  // Channels 0, 1, 2 are x, y, z and from 3 on the values; capacity() floats each, of which the unused x are infinite.
  // Valid until the block changes.
  const float* channel(int c) const { return data_.get() + static_cast<std::size_t>(c) * capacity(); }
  float* channel(int c) { return data_.get() + static_cast<std::size_t>(c) * capacity(); }

  // kLane floats of a channel, from the atom `first`, a multiple of kLane, on.
  Lane lane(int c, std::uint32_t first) const { return Eigen::Map<const Lane>(channel(c) + first); }

  Eigen::Vector3f center(std::uint32_t i) const { return {channel(0)[i], channel(1)[i], channel(2)[i]}; }

  // Sends for the coordinates, that a search will read soon.
  void prefetch() const {
    constexpr std::uint32_t kCacheLine = 64 / sizeof(float);
    for (std::uint32_t i = 0; i < 3 * capacity(); i += kCacheLine) __builtin_prefetch(data_.get() + i);
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
  void resize(std::uint32_t size);

  std::unique_ptr<float[]> data_;
  std::uint32_t size_ = 0;
  std::uint8_t value_count_;
};

}  // namespace atom_map
