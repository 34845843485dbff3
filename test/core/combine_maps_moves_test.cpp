// A map that is moved is one rigid body: its atoms keep what they store, and it answers the same where it now lies.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "atom_mapping/query/combine_maps.h"
#include "atom_mapping/query/occupancy.h"
#include "check_map.h"
#include "combine_maps_seeds.h"
#include "map_file_folder.h"

namespace atom_map {
namespace {

// The least distance to an atom of the same values, of atom by atom; the greatest of them all.
float farthestCounterpart(const AtomMap& map, const AtomMap& other) {
  float farthest = 0.0F;
  map.atoms().forEach([&](const ConstAtomRef& atom) {
    const auto found = other.atoms().nearest(other.toLocal(map.toMap(atom.center())), map.radius());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->values[0], atom.value());
    if (map.mode() == Mode::kSignedDistance) {
      EXPECT_EQ(found->values[1], atom.value(1));
    }
    farthest = std::max(farthest, std::sqrt(found->squared_distance));
  });
  return farthest;
}

TEST_P(CombineMaps, ThereAndBackIsTheSameMap) {
  for (const Mode mode : {Mode::kOccupancy, Mode::kSignedDistance}) {
    const AtomMap map = drawMap(parametersOf(mode), 5000, GetParam());
    const Pose there = drawPose(random_, 1e5);
    const AtomMap back = transformed(transformed(map, there), there.inverse());
    ASSERT_EQ(back.atoms().size(), map.atoms().size());
    EXPECT_LT(farthestCounterpart(map, back), 1e-5F);
  }
}

// Where each atom lies, by what it stores; without those that store the same as another.
std::map<std::array<float, 2>, Eigen::Vector3d> placesOf(const AtomMap& map) {
  std::map<std::array<float, 2>, Eigen::Vector3d> places;
  std::set<std::array<float, 2>> ambiguous;
  const bool has_variance = map.mode() == Mode::kSignedDistance;
  map.atoms().forEach([&](const ConstAtomRef& atom) {
    const std::array<float, 2> values{atom.value(), has_variance ? atom.value(1) : 0.0F};
    if (!places.emplace(values, map.toMap(atom.center())).second) ambiguous.insert(values);
  });
  for (const auto& values : ambiguous) places.erase(values);
  return places;
}

TEST_P(CombineMaps, AtomsMoveAsOneRigidBody) {
  for (const Mode mode : {Mode::kOccupancy, Mode::kSignedDistance}) {
    const AtomMap map = drawMap(parametersOf(mode), 3000, GetParam());
    const auto before = placesOf(map);
    const auto after = placesOf(transformed(map, drawPose(random_, 1e4)));
    ASSERT_EQ(after.size(), before.size());
    ASSERT_GT(before.size(), 500U);
    for (auto a = before.begin(), b = after.begin(); a != before.end(); ++a, ++b) {
      ASSERT_EQ(a->first, b->first) << "it stores what it stored";
      for (const auto& [values, place] : {*before.begin(), *before.rbegin(), *std::next(before.begin(), 250)}) {
        EXPECT_NEAR((b->second - after.at(values)).norm(), (a->second - place).norm(), 2e-5);
      }
    }
  }
}

TEST_P(CombineMaps, AMapThatWasMovedAnswersTheSameWhereItNowLies) {
  const AtomMap map = drawMap(parametersOf(Mode::kOccupancy), 30000, GetParam());
  const Pose pose = drawPose(random_, 1e3);
  const AtomMap moved = transformed(map, pose);
  int known = 0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3f point = drawWithin(random_, 15.0F);
    const auto expected = interpolate(map, point);
    const auto answer = interpolate(moved, moved.toLocal(pose * map.toMap(point)));
    if (!expected || !answer) continue;  // at the rim, rounding decides
    EXPECT_NEAR(*answer, *expected, 1e-2F);
    ++known;
  }
  EXPECT_GT(known, 50);
}

TEST_P(CombineMaps, AMapThatWasMovedCanBeSavedAndLoaded) {
  const MappingParameters parameters = parametersOf(Mode::kOccupancy);
  const Pose pose = drawPose(random_, 1e4);
  const AtomMap moved = transformed(drawMap(parameters, 20000, GetParam()), pose);
  const std::string file = testing::TempDir() + "/combine_maps_" + std::to_string(getpid()) + ".h5";
  saveMap(copyOf(parameters, transformed(drawMap(parameters, 20000, GetParam()), pose)), file);
  EXPECT_EQ(bytesOf(loadMap(file).map), bytesOf(moved));
  std::filesystem::remove(file);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CombineMaps, tenSeeds());

}  // namespace
}  // namespace atom_map
