// Maps of parts of a drive, in frames of their own, merge to the map of the whole drive.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "atom_mapping/map/mapper.h"
#include "atom_mapping/query/combine_maps.h"
#include "atom_mapping/query/gaussian_process.h"
#include "atom_mapping/query/occupancy.h"
#include "check_map.h"
#include "draw.h"
#include "simulated.h"

namespace atom_map {
namespace {

MappingParameters coarse() {
  MappingParameters parameters;
  parameters.radius = 0.5;
  parameters.scan.horizontal_resolution = 0.6;
  return parameters;
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
