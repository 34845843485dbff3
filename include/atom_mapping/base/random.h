// SplitMix64 (Steele, Lea, Flood 2014): the same numbers on every platform, unlike the distributions of <random>.
#pragma once

#include <cstdint>

namespace atom_map {

inline std::uint64_t mixBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() { return mixBits(state_ += 0x9e3779b97f4a7c15ULL); }

  // Uniform in [0, 1), with the 24 bits that a float can hold.
  float uniform() { return static_cast<float>(next() >> 40) * 0x1p-24F; }

 private:
  std::uint64_t state_;
};

// The draws of a map's scan, counted from 0: the same for every map of that seed.
inline Random randomOfScan(std::uint32_t seed, std::uint64_t scan) {
  return Random(mixBits(seed) + scan);
}

}  // namespace atom_map
