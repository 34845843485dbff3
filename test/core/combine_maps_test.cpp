#include "atom_mapping/map/combine_maps.h"

#include <gtest/gtest.h>

#include "atom_mapping/query/occupancy.h"
#include "atom_mapping/scan/snap.h"
#include "check_map.h"
#include "list_merge.h"
#include "map_file_folder.h"
#include "simulated.h"

namespace atom_map {
namespace {

MappingParameters coarse() {
  MappingParameters parameters;
  parameters.radius = 0.5;
  parameters.scan.horizontal_resolution = 0.6;
  return parameters;
}

AtomMap mapOf(const SortedAtoms& atoms) {
  AtomMap map(Mode::kOccupancy, double{kRadius});
  for (const auto& atom : atoms) map.atoms().insert({atom[0], atom[1], atom[2]}, &atom[3]);
  return map;
}

SortedAtoms drawAtoms(Random& random, const OccupancyParameters& parameters) {
  ListMerge list(parameters);
  for (int i = 0; i < 3; ++i) {
    Scan scan = drawScan(random, 3.0F);
    snapToLattice(scan.occupied, kRadius);
    snapToLattice(scan.free, kRadius);
    list.add(scan);
  }
  return list.atoms();
}

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

class CombineMaps : public testing::TestWithParam<std::uint64_t> {
 protected:
  Random random_{GetParam()};
};

TEST_P(CombineMaps, ThereAndBackIsTheSameMap) {
  for (const Mode mode : {Mode::kOccupancy, Mode::kSignedDistance}) {
    const AtomMap map = drawMap(parametersOf(mode), 5000, GetParam());
    const Pose there = drawPose(random_, 1e5);
    const AtomMap back = transformed(transformed(map, there), there.inverse());
    ASSERT_EQ(back.atoms().size(), map.atoms().size());
    EXPECT_LT(farthestCounterpart(map, back), 1e-5F);
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

TEST_P(CombineMaps, MergesByTheRulesOfScans) {
  const OccupancyParameters parameters;
  const SortedAtoms a = drawAtoms(random_, parameters);
  const SortedAtoms b = drawAtoms(random_, parameters);
  AtomMap merged = mapOf(a);
  const AtomMap other = mapOf(b);
  mergeInto(merged, other, parameters);
  Scan a_scan;  // no two of them overlap: added to an empty list they stay as they are
  for (const auto& atom : a) a_scan.free.push_back({{atom[0], atom[1], atom[2]}, atom[3]});
  Scan b_scan;
  other.atoms().forEach([&](const ConstAtomRef& atom) {
    (atom.value() > 0.0F ? b_scan.occupied : b_scan.free).push_back({atom.center(), atom.value()});
  });
  ListMerge list(parameters);
  list.add(a_scan);
  list.add(b_scan);
  const SortedAtoms expected = list.atoms();
  SortedAtoms atoms;
  merged.atoms().forEach([&](const ConstAtomRef& atom) {
    atoms.push_back({atom.center().x(), atom.center().y(), atom.center().z(), atom.value()});
  });
  std::sort(atoms.begin(), atoms.end());
  ASSERT_EQ(atoms.size(), expected.size());
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    for (int c = 0; c < 3; ++c) ASSERT_EQ(atoms[i][c], expected[i][c]);
    ASSERT_NEAR(atoms[i][3], expected[i][3], 1e-4F);
  }
  expectNoOverlap(merged);
  expectWithinClamps(merged, parameters.max_log_odds);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CombineMaps, testing::Range<std::uint64_t>(1, 11));

TEST(CombineMapsOfDrives, TwoHalvesOfADriveMakeTheWhole) {
  const Drive drive = makeDrive("hall", 8, 5);
  const Pose b_to_a = Eigen::Translation3d(300, -20, 1) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ());
  Mapper whole(coarse());
  Mapper a(coarse());
  Mapper b(coarse());
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    whole.insertScan(drive.scans[i], drive.poses[i]);
    if (i < 4) a.insertScan(drive.scans[i], drive.poses[i]);
    if (i >= 4) b.insertScan(drive.scans[i], b_to_a.inverse() * drive.poses[i]);
  }
  const AtomMap moved = b.read([&](const AtomMap& map) { return transformed(map, b_to_a); });
  a.write([&](AtomMap& map) { mergeInto(map, moved, coarse().occupancy); });
  Random random(1);
  int asked = 0;
  int agreed = 0;
  for (const LidarScan& scan : drive.scans) {
    const Pose& pose = drive.poses[static_cast<std::size_t>(&scan - drive.scans.data())];
    for (std::size_t i = 0; i < scan.points.size(); i += 53) {
      const Eigen::Vector3d point = pose * (draw(random, 0.1F, 1.0F) * scan.points[i]).cast<double>();
      const auto at = [&](const AtomMap& map) { return classify(interpolate(map, map.toLocal(point))); };
      ++asked;
      agreed += whole.read(at) == a.read(at) ? 1 : 0;
    }
  }
  EXPECT_GT(asked, 1000);
  EXPECT_GE(agreed, asked * 95 / 100) << "of " << asked;
}

}  // namespace
}  // namespace atom_map
