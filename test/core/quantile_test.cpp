#include "atom_mapping/base/quantile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace atom_map {
namespace {

class Quantile : public testing::TestWithParam<unsigned> {};

// As it is defined, value by value.
TEST_P(Quantile, IsTheLeastThatSoManyDoNotExceed) {
  std::mt19937 random(GetParam());
  std::vector<int> values(std::uniform_int_distribution<std::size_t>(1, 40)(random));
  for (int& value : values) value = std::uniform_int_distribution<int>(-9, 9)(random);
  for (const double share : {1e-9, 0.01, 0.25, 0.5, 0.75, 0.99, 1.0}) {
    const auto reached = [&](int bound) {
      const auto below = std::count_if(values.begin(), values.end(), [&](int value) { return value <= bound; });
      return static_cast<double>(below) >= share * static_cast<double>(values.size());
    };
    int least = 10;
    for (const int value : values) least = reached(value) ? std::min(least, value) : least;
    EXPECT_EQ(quantile(values, share), least) << share << " of " << values.size();
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Quantile, testing::Range(1U, 41U));

}  // namespace
}  // namespace atom_map
