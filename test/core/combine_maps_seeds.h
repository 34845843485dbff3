// What the tests of moved and of merged maps share: draws from ten seeds.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "atom_mapping/base/random.h"

namespace atom_map {

class CombineMaps : public testing::TestWithParam<std::uint64_t> {
 protected:
  Random random_{GetParam()};
};

inline auto tenSeeds() {
  return testing::Range<std::uint64_t>(1, 11);
}

}  // namespace atom_map
