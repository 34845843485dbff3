#include "atom_mapping/map/atom_block.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

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
  return size_ == 0 ? 0 : sizeof(float) * offset(3 + value_count_) + 8;
}

// Keeps the first atoms. The allocation follows the size, so that a block holds nothing beside its atoms but unused coordinates.
void AtomBlock::resize(std::uint32_t size) {
  AtomBlock resized(value_count_);
  resized.signs_ = signs_;
  resized.size_ = size;
  if (size > 0) resized.data_ = std::make_unique<float[]>(resized.offset(3 + value_count_));
  const std::uint32_t kept = std::min(size, size_);
  for (int c = 0; kept > 0 && c < 3 + value_count_; ++c) std::copy_n(channel(c), kept, resized.mutableChannel(c));
  std::fill(resized.mutableChannel(0) + kept, resized.mutableChannel(0) + resized.capacity(),
            std::numeric_limits<float>::infinity());
  *this = std::move(resized);
}

}  // namespace atom_map
