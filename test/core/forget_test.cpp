// What is forgotten, against a plain list of distances.
#include "atom_mapping/map/forget.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "check_map.h"
#include "distributions.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

AtomMap mapOf(const Centers& centers) {
  AtomMap map(Mode::kOccupancy, kCell);
  map.anchor(Vector3d(1e5, -1e5, 10.0));
  for (const Vector3f& center : centers) {
    const float value = 1.0F;
    map.atoms().insert(center, &value);
  }
  return map;
}

std::vector<double> distancesFrom(const AtomMap& map, const Vector3d& place) {
  std::vector<double> distances;
  map.atoms().forEach([&](ConstAtomRef atom) { distances.push_back((map.toMap(atom.center()) - place).norm()); });
  std::sort(distances.begin(), distances.end());
  return distances;
}

class Forgetting : public testing::TestWithParam<Distribution> {
 protected:
  // Which the map's single precision holds exactly.
  Vector3d drawPlace(const AtomMap& map) {
    const Vector3f& atom = GetParam().centers[drawIndex(random_, GetParam().centers.size())];
    return map.toMap(atom + drawWithin(random_, 3.0F));
  }

  Random random_{21};
};

TEST_P(Forgetting, TheRadiusOfTheNearestHoldsAsManyAsAskedForUnlessSomeLieAsFar) {
  const AtomMap map = mapOf(GetParam().centers);
  for (int i = 0; i < 20; ++i) {
    const Vector3f p = map.toLocal(drawPlace(map));
    const std::size_t count = drawIndex(random_, map.atoms().size());
    const float radius = radiusOfNearest(map.atoms(), p, count);
    std::size_t within = 0;
    map.atoms().forEachWithin(p, radius, [&](ConstAtomRef, float) { ++within; });
    EXPECT_LE(within, count);
    std::size_t within_or_there = 0;  // to rounding
    map.atoms().forEachWithin(p, 1.000002F * radius + 1e-6F, [&](ConstAtomRef, float) { ++within_or_there; });
    EXPECT_GT(within_or_there, count);
  }
}

TEST_P(Forgetting, TheFarthestGoAndTheLimitHolds) {
  for (int i = 0; i < 20; ++i) {
    AtomMap map = mapOf(GetParam().centers);
    const Vector3d place = drawPlace(map);
    std::vector<double> nearest = distancesFrom(map, place);
    MapLimit limit;
    if (i % 2 == 0) limit.atoms = drawIndex(random_, map.atoms().size() + 2);
    if (i % 2 == 1) limit.bytes = drawIndex(random_, map.atoms().bytes() + 1000);
    const bool held = limit.holds(map.atoms());
    const std::size_t forgotten = forgetFarthest(map, limit, place);
    EXPECT_TRUE(limit.holds(map.atoms()));
    EXPECT_EQ(forgotten, nearest.size() - map.atoms().size());
    EXPECT_EQ(forgotten == 0, held);
    nearest.resize(map.atoms().size());
    const std::vector<double> kept = distancesFrom(map, place);
    for (std::size_t k = 0; k < kept.size(); ++k) ASSERT_NEAR(kept[k], nearest[k], 1e-5 * (1.0 + nearest[k]));
  }
}

std::vector<Distribution> notEmpty() {
  std::vector<Distribution> all = distributions();
  all.erase(std::remove_if(all.begin(), all.end(), [](const auto& d) { return d.centers.empty(); }), all.end());
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, Forgetting, testing::ValuesIn(notEmpty()),
                         [](const auto& instance) { return instance.param.name; });

TEST(Forgetting, OneAtomOfASphereIsNoMoreThanAnother) {
  Random random(3);
  Centers sphere;  // all as far as one another from the origin
  for (const float x : {-2.0F, 2.0F}) {
    for (int axis = 0; axis < 3; ++axis) sphere.emplace_back(x * Vector3f::Unit(axis));
  }
  AtomMap map = mapOf(sphere);
  MapLimit limit;
  limit.atoms = 3;
  EXPECT_EQ(forgetFarthest(map, limit, map.origin()), 6U);
}

TEST(Forgetting, TheWindowHoldsTheSensorsBallAndReachesASlackBeyondItAtMost) {
  Random random(4);
  AtomMap map(Mode::kOccupancy, 0.25);
  map.anchor(Vector3d(300.0, 0.0, -7.0));
  for (int i = 0; i < 10000; ++i) {
    const auto window = static_cast<double>(draw(random, 1.0F, 200.0F));
    const Vector3d sensor = drawWithin(random, 1000.0F).cast<double>();
    const KeptBall kept = windowAround(map, window, sensor);
    const double aside = (map.toMap(kept.center) - sensor).norm();
    ASSERT_LE(aside + window, static_cast<double>(kept.radius) + 1e-4);
    ASSERT_LE(aside + static_cast<double>(kept.radius), (1.0 + kWindowSlack) * window + 1e-4);
  }
}

}  // namespace
}  // namespace atom_map
