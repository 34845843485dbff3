// Whether any point of a scan lies near: what its boxes say, against every point asked.
#include "atom_mapping/scan/point_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "distributions.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

std::vector<SurfacePoint> surfaceOf(const Centers& places) {
  std::vector<SurfacePoint> surface;
  for (const Vector3f& place : places) {
    surface.push_back({place, Vector3f::UnitZ(), std::numeric_limits<float>::infinity()});
  }
  return surface;
}

class PointBoxesOf : public testing::TestWithParam<Distribution> {};

TEST_P(PointBoxesOf, FindWhatEveryPointAskedFinds) {
  const Centers& places = GetParam().centers;
  const PointBoxes boxes(surfaceOf(places));
  Random random(1);
  int near = 0;
  for (int i = 0; i < 2000; ++i) {
    const bool beside_one = i % 2 == 0 && !places.empty();
    const Vector3f p = beside_one ? Vector3f(places[drawIndex(random, places.size())] + drawWithin(random, 2.0F))
                                  : drawWithin(random, 60.0F);
    const float radius = draw(random, 0.0F, 3.0F);
    const bool is_any = std::any_of(places.begin(), places.end(), [&](const Vector3f& place) {
      const Vector3f offset = place - p;
      return offset.x() * offset.x() + offset.y() * offset.y() + offset.z() * offset.z() < radius * radius;
    });
    ASSERT_EQ(boxes.isAnyWithin(p, radius), is_any) << p.transpose() << ", " << radius << " m";
    near += is_any ? 1 : 0;
  }
  EXPECT_TRUE(places.empty() || near > 100) << "or the test asks nothing";
}

INSTANTIATE_TEST_SUITE_P(All, PointBoxesOf, testing::ValuesIn(distributions()),
                         [](const auto& test) { return test.param.name; });

TEST(PointBoxes, APointLiesNotNearerThanItsDistance) {
  const PointBoxes boxes(surfaceOf({{1.0F, 0.0F, 0.0F}}));
  EXPECT_FALSE(boxes.isAnyWithin({0.0F, 0.0F, 0.0F}, 1.0F));
  EXPECT_TRUE(boxes.isAnyWithin({0.0F, 0.0F, 0.0F}, 1.001F));
}

TEST(PointBoxes, WithoutPointsNoneIsNear) {
  const PointBoxes boxes(surfaceOf({}));
  EXPECT_FALSE(boxes.isAnyWithin({0.0F, 0.0F, 0.0F}, 1e6F));
}

}  // namespace
}  // namespace atom_map
