#include "atom_mapping/query/combine_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "atom_mapping/query/gaussian_process.h"
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

// In the map frame.
std::vector<std::array<double, 5>> sortedAtoms(const AtomMap& map) {
  std::vector<std::array<double, 5>> atoms;
  map.atoms().forEach([&](const ConstAtomRef& atom) {
    const float variance = map.mode() == Mode::kSignedDistance ? atom.value(1) : 0.0F;
    const Eigen::Vector3d center = map.toMap(atom.center());
    atoms.push_back({center.x(), center.y(), center.z(), atom.value(), variance});
  });
  std::sort(atoms.begin(), atoms.end());
  return atoms;
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

TEST_P(CombineMaps, WhereOnlyOneMapHasAtomsTheyKeepWhatTheyStore) {
  for (const Mode mode : {Mode::kOccupancy, Mode::kSignedDistance}) {
    const MappingParameters parameters = parametersOf(mode);
    const AtomMap a = drawMap(parameters, 1000, GetParam());
    const AtomMap b = drawMap(parameters, 1000, GetParam() + 100);
    AtomMap merged = drawMap(parameters, 1000, GetParam());
    const MergeReport report = mergeInto(merged, b, parameters);
    EXPECT_EQ(merged.atoms().size(), a.atoms().size() + report.inserted);
    expectNoOverlap(merged);
    int alone = 0;
    for (const auto& [one, other] : {std::make_pair(&a, &b), std::make_pair(&b, &a)}) {
      one->atoms().forEach([&, other = other](const ConstAtomRef& atom) {
        if (other->atoms().anyWithin(atom.center(), 2.001F * a.radius())) return;
        const auto found = merged.atoms().nearest(atom.center(), 1e-3F * a.radius());
        ASSERT_TRUE(found);
        ++alone;
        EXPECT_EQ(found->values[0], atom.value());
        if (mode == Mode::kSignedDistance) {
          EXPECT_EQ(found->values[1], atom.value(1));
        }
      });
    }
    EXPECT_GT(alone, 200);
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
  mergeInto(merged, other, MappingParameters());
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

AtomMap oneAtom(const Eigen::Vector3f& center, float distance, float variance) {
  AtomMap map(Mode::kSignedDistance, double{kRadius});
  const std::array<float, 2> values{distance, variance};
  map.atoms().insert(center, values.data());
  return map;
}

TEST_P(CombineMaps, DistancesAtOnePlaceBecomeTheirMeanByInverseVariance) {
  const Eigen::Vector3f center = 0.25F * Eigen::Vector3f(1, 2, 3);
  const float a = draw(random_, -0.5F, 0.5F);
  const float b = draw(random_, -0.5F, 0.5F);
  const float sure = draw(random_, 1e-4F, 1e-3F);
  const float unsure = draw(random_, 1e-2F, 1e-1F);
  for (const auto& [of_a, of_b] : {std::make_pair(sure, unsure), std::make_pair(unsure, sure)}) {
    AtomMap map = oneAtom(center, a, of_a);
    const MergeReport report = mergeInto(map, oneAtom(center, b, of_b), parametersOf(Mode::kSignedDistance));
    EXPECT_EQ(report.updates, 1U);
    const auto merged = map.atoms().nearest(center, kRadius);
    ASSERT_TRUE(merged);
    EXPECT_NEAR(merged->values[0], (a / of_a + b / of_b) / (1.0F / of_a + 1.0F / of_b), 1e-5F);
    EXPECT_NEAR(merged->values[1], 1.0F / (1.0F / of_a + 1.0F / of_b), 1e-6F);
  }
}

TEST(CombineMapsOfDistances, VariancesOfZeroAreNoDivisionByZero) {
  for (const float of_a : {0.0F, 0.1F}) {
    AtomMap map = oneAtom(Eigen::Vector3f::Zero(), 0.1F, of_a);
    mergeInto(map, oneAtom(Eigen::Vector3f::Zero(), 0.2F, 0.0F), parametersOf(Mode::kSignedDistance));
    const auto merged = map.atoms().nearest(Eigen::Vector3f::Zero(), kRadius);
    EXPECT_EQ(merged->values[0], of_a > 0.0F ? 0.2F : 0.1F);
    EXPECT_EQ(merged->values[1], 0.0F);
  }
}

// Atoms about a plane, each a lattice of its own; what one map's tell at the other's centres lies up to 2r along the normal.
TEST_P(CombineMaps, WhatAnAtomTellsIsTheDistanceWhereTheOtherLies) {
  const MappingParameters parameters = parametersOf(Mode::kSignedDistance);
  const Eigen::Vector3f normal = drawDirection(random_);
  const auto plane = [&](const Eigen::Vector3f& shift) {
    AtomMap map(Mode::kSignedDistance, parameters.radius);
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3f cell(static_cast<float>(i % 20), static_cast<float>(i / 20 % 20),
                                 static_cast<float>(i / 400));
      const Eigen::Vector3f center = 2.0F * kRadius * (cell - Eigen::Vector3f(10, 10, 2.5F)) + shift;
      const std::array<float, 2> values{normal.dot(center), 0.01F};
      map.atoms().insert(center, values.data());
    }
    return map;
  };
  AtomMap merged = plane(Eigen::Vector3f::Zero());
  const MergeReport report = mergeInto(merged, plane(drawWithin(random_, kRadius)), parameters);
  EXPECT_GT(report.updates, 2000U);
  double squares = 0.0;
  merged.atoms().forEach([&](const ConstAtomRef& atom) {
    squares += std::pow(static_cast<double>(atom.value() - normal.dot(atom.center())), 2);
  });
  EXPECT_LT(std::sqrt(squares / static_cast<double>(merged.atoms().size())), 0.02 * parameters.radius);
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
  a.write([&](AtomMap& map) { mergeInto(map, moved, coarse()); });
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

// Of a map's estimates at points that the other knows too, within 2r of surfaces that rays met (m).
double errorOf(const AtomMap& map, const AtomMap& other, const Drive& drive, const MappingParameters& parameters) {
  GaussianProcess process(map, parameters.gaussian_process);
  GaussianProcess other_process(other, parameters.gaussian_process);
  Random random(5);
  double squares = 0.0;
  int known = 0;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    for (std::size_t k = 0; k < drive.scans[i].points.size(); k += 17) {
      const Eigen::Vector3d point = drive.poses[i] * drive.scans[i].points[k].cast<double>() +
                                    2.0 * parameters.radius * drawWithin(random, 1.0F).cast<double>();
      const double truth = drive.scene.signedDistance(point);
      if (std::abs(truth) > 2.0 * parameters.radius) continue;
      const auto estimate = process.estimate(map.toLocal(point));
      if (!estimate || !other_process.estimate(other.toLocal(point))) continue;
      ++known;
      squares += std::pow(static_cast<double>(estimate->value) - truth, 2);
    }
  }
  EXPECT_GT(known, 1000);
  return std::sqrt(squares / known);
}

// Even scans make A and odd ones B, in a frame of its own.
TEST(CombineMapsOfDrives, MergedDistancesAreNoLessTrue) {
  MappingParameters parameters = coarse();
  parameters.mode = Mode::kSignedDistance;
  const Pose b_to_a = Eigen::Translation3d(30, -20, 1) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ());
  for (const char* scene : {"hall", "campus"}) {
    const Drive drive = makeDrive(scene, 20, 3);
    Mapper a(parameters);
    Mapper b(parameters);
    for (std::size_t i = 0; i < drive.scans.size(); ++i) {
      if (i % 2 == 0) a.insertScan(drive.scans[i], drive.poses[i]);
      if (i % 2 == 1) b.insertScan(drive.scans[i], b_to_a.inverse() * drive.poses[i]);
    }
    const AtomMap moved = b.read([&](const AtomMap& map) { return transformed(map, b_to_a); });
    const AtomMap alone = a.read([](const AtomMap& map) { return transformed(map, Pose::Identity()); });
    a.write([&](AtomMap& map) { mergeInto(map, moved, parameters); });
    a.read([&](const AtomMap& map) {
      expectNoOverlap(map);
      const double before = errorOf(alone, map, drive, parameters);
      const double after = errorOf(map, alone, drive, parameters);
      std::printf("%s: rms error of A %.4f r, merged %.4f r\n", scene, before / parameters.radius,
                  after / parameters.radius);
      EXPECT_LE(after, before);
      EXPECT_GT(map.atoms().size(), alone.atoms().size());
    });
  }
}

// A scan's atoms lie on a lattice, to which merging brings them back.
TEST(CombineMapsOfDrives, ThereAndBackIntoAnEmptyMapIsTheSameToTheBit) {
  const Drive drive = makeDrive("hall", 4, 5);
  for (const Mode mode : {Mode::kOccupancy, Mode::kSignedDistance}) {
    MappingParameters parameters = coarse();
    parameters.mode = mode;
    parameters.scan.thin_width = 0.0;  // thin things' atoms are set aside of others, off the lattice
    Mapper mapper(parameters);
    for (std::size_t i = 0; i < drive.scans.size(); ++i) mapper.insertScan(drive.scans[i], drive.poses[i]);
    mapper.read([&](const AtomMap& map) {
      EXPECT_EQ(bytesOf(transformed(map, Pose::Identity())), bytesOf(map)) << "in its order";
      const Pose there = Eigen::Translation3d(7, -20, 1) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.6, 0, 0.8));
      AtomMap back(mode, parameters.radius);
      const MergeReport report = mergeInto(back, transformed(transformed(map, there), there.inverse()), parameters);
      EXPECT_EQ(report.updates, 0U);
      EXPECT_TRUE(sortedAtoms(back) == sortedAtoms(map));
    });
  }
}

}  // namespace
}  // namespace atom_map
