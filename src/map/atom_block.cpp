#include "atom_mapping/map/atom_block.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace atom_map {

void AtomBlock::push(const Eigen::Vector3f& center, const float* values) {
  resize(size_ + 1);
  for (int c = 0; c < 3; ++c) mutableChannel(c)[size_ - 1] = center[c];
  for (int v = 0; v < value_count_; ++v) setValue(size_ - 1, v, values[v]);
}

void AtomBlock::push(const AtomBlock& other, std::uint32_t i) {
  assert(i < other.size_ && value_count_ == other.value_count_);
  resize(size_ + 1);
  for (int c = 0; c < 3; ++c) mutableChannel(c)[size_ - 1] = other.channel(c)[i];
  for (int v = 0; v < value_count_; ++v) setValue(size_ - 1, v, other.channel(3 + v)[i]);
}

void AtomBlock::remove(std::uint32_t i) {
  assert(i < size_);
  for (int c = 0; c < 3 + value_count_; ++c) mutableChannel(c)[i] = channel(c)[size_ - 1];
  mutableChannel(0)[size_ - 1] = std::numeric_limits<float>::infinity();
  resize(size_ - 1);
}

std::size_t AtomBlock::bytes() const {
  return size_ == 0 ? 0 : sizeof(float) * (3U + value_count_) * capacity() + 8;
}

// Keeps the first atoms. The allocation follows the capacity, so a block never holds a lane that it does not use.
void AtomBlock::resize(std::uint32_t size) {
  const std::uint32_t old_capacity = capacity();
  const std::uint32_t kept = std::min(size, size_);
  size_ = size;
  if (capacity() == old_capacity) return;
  auto data = size == 0 ? nullptr : std::make_unique<float[]>(std::size_t{3U + value_count_} * capacity());
  for (std::uint32_t c = 0; size != 0 && c < 3U + value_count_; ++c) {
    std::copy_n(data_.get() + std::size_t{c} * old_capacity, kept, data.get() + std::size_t{c} * capacity());
  }
  std::fill(data.get() + kept, data.get() + capacity(), std::numeric_limits<float>::infinity());
  data_ = std::move(data);
}

}  // namespace atom_map
