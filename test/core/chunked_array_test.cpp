// An array in chunks holds what a vector holds, and tells what it takes.
#include "atom_mapping/map/chunked_array.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace atom_map {
namespace {

TEST(ChunkedArray, HoldsWhatAVectorHolds) {
  ChunkedArray<std::unique_ptr<int>> array;
  std::vector<int> expected;
  for (int i = 0; i < 20000; ++i) {
    ASSERT_EQ(array.size(), expected.size());
    array.emplaceBack(std::make_unique<int>(7 * i));
    expected.push_back(7 * i);
    *array[static_cast<std::size_t>(i) / 2] += 1;
    expected[static_cast<std::size_t>(i) / 2] += 1;
    if (i % 1000 == 0) array.shrink();
  }
  for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(*std::as_const(array)[i], expected[i]) << i;
}

TEST(ChunkedArray, TellsItsBytesAndHowTheyWillGrow) {
  ChunkedArray<double> array;
  EXPECT_EQ(array.bytes(), 0U);
  for (std::size_t i = 0; i < 20000; ++i) {
    const std::size_t told = array.bytes() + array.growth();
    array.emplaceBack(0.0);
    ASSERT_EQ(array.bytes(), told) << i;
    ASSERT_GE(array.bytes(), array.size() * sizeof(double));
    if (i % 777 == 0) array.shrink();
  }
}

// However large it is, what it does not use is less than 256 elements, or than what it holds; and the first ones never move again.
TEST(ChunkedArray, HoldsLittleThatItDoesNotUse) {
  ChunkedArray<double> array;
  constexpr std::size_t kTable = 1024;  // bytes, of the chunks' addresses
  for (std::size_t i = 1; i <= 50000; ++i) {
    array.emplaceBack(0.0);
    const std::size_t unused = array.bytes() / sizeof(double) - i;
    ASSERT_LE(unused, std::min<std::size_t>(i, 256) + kTable / sizeof(double)) << i;
  }
  const double* const first = &array[0];
  for (std::size_t i = 0; i < 50000; ++i) array.emplaceBack(0.0);
  EXPECT_EQ(&array[0], first);
}

}  // namespace
}  // namespace atom_map
