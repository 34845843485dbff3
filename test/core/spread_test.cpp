#include "atom_mapping/base/spread.h"

#include <gtest/gtest.h>

namespace atom_map {
namespace {

TEST(Spread, OfKnownValues) {
  std::vector<double> values;
  for (int i = 100; i > 0; --i) values.push_back(i);
  const Spread spread = spreadOf(values);
  EXPECT_DOUBLE_EQ(spread.mean, 50.5);
  EXPECT_DOUBLE_EQ(spread.median, 50.0);
  EXPECT_DOUBLE_EQ(spread.p95, 95.0);
}

TEST(Spread, OfFewValuesIsOneOfThem) {
  EXPECT_DOUBLE_EQ(spreadOf({3.0}).median, 3.0);
  EXPECT_DOUBLE_EQ(spreadOf({3.0}).p95, 3.0);
  EXPECT_DOUBLE_EQ(spreadOf({2.0, 1.0}).median, 1.0);
  EXPECT_DOUBLE_EQ(spreadOf({2.0, 1.0}).p95, 2.0);
  EXPECT_DOUBLE_EQ(spreadOf({}).mean, 0.0);
}

}  // namespace
}  // namespace atom_map
