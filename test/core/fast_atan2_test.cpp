#include "atom_mapping/base/fast_atan2.h"

#include <gtest/gtest.h>

#include <cmath>

#include "draw.h"

namespace atom_map {
namespace {

TEST(FastAtan2, IsNearTheLibrarysInAllDirectionsAndForAllLengths) {
  Random random(1);
  for (int i = 0; i < 200000; ++i) {
    const float angle = draw(random, -3.1415925F, 3.1415925F);
    const float length = std::pow(10.0F, draw(random, -6.0F, 6.0F));
    const float y = length * std::sin(angle);
    const float x = length * std::cos(angle);
    ASSERT_NEAR(fastAtan2(y, x), std::atan2(y, x), 5e-6F) << y << ", " << x;
  }
}

TEST(FastAtan2, HoldsOnTheAxesAndAtTheOrigin) {
  constexpr auto kHalfPi = static_cast<float>(0.5 * M_PI);
  EXPECT_EQ(fastAtan2(0.0F, 0.0F), 0.0F);
  EXPECT_EQ(fastAtan2(0.0F, 1.0F), 0.0F);
  EXPECT_FLOAT_EQ(fastAtan2(0.0F, -1.0F), 2.0F * kHalfPi);
  EXPECT_FLOAT_EQ(fastAtan2(-0.0F, -1.0F), -2.0F * kHalfPi);
  EXPECT_FLOAT_EQ(fastAtan2(3.0F, 0.0F), kHalfPi);
  EXPECT_FLOAT_EQ(fastAtan2(-3.0F, 0.0F), -kHalfPi);
}

}  // namespace
}  // namespace atom_map
