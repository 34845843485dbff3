// What holds of a map with limits, after every scan.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "atom_mapping/base/check_parameters.h"
#include "atom_mapping/map/mapper.h"
#include "check_map.h"
#include "simulated.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kRange = 12.0;  // m
constexpr int kScans = 40;

// A corridor of 300 m with a column every 7 m; the sensor drives straight through it, and sees no place again that it left
// farther than its range behind.
const Drive& corridor() {
  static const Drive drive = [] {
    std::vector<Solid> solids{
        {makeBox(Pose(Eigen::Translation3d(140.0, 0.0, 1.0)), {300.0, 8.0, 5.0}), SurfaceKind::kWall, true}};
    for (int i = 0; i < 40; ++i) {
      const double side = i % 2 == 0 ? 2.5 : -2.5;
      solids.push_back({Cylinder{{7.0 * i, side, -1.5}, 0.3, 5.0}, SurfaceKind::kColumn});
    }
    Drive made{"corridor", Scene("corridor", std::move(solids), Eigen::AlignedBox3d(Vector3d::Zero())), {}, {}, {}};
    Trajectory straight;
    straight.base_pose = [](double t) { return Pose(Eigen::Translation3d(50.0 * t, 0.1, 0.0)); };
    LidarModel model;
    model.firings = 240;
    for (int i = 0; i < kScans; ++i) {
      made.scans.push_back(toLidarScan(simulateScan(made.scene, straight, 0.1 * i, model, 1)));
      made.poses.push_back(straight.sensorPose(0.1 * i));
    }
    return made;
  }();
  return drive;
}

using Center = std::array<float, 3>;
using Atoms = std::map<Center, std::array<float, 2>>;

Atoms atomsOf(const Mapper& mapper) {
  return mapper.read([](const AtomMap& map) {
    Atoms atoms;
    map.atoms().forEach([&](ConstAtomRef atom) {
      const Vector3f c = atom.center();
      atoms[{c.x(), c.y(), c.z()}] = {atom.value(), map.mode() == Mode::kOccupancy ? 0.0F : atom.value(1)};
    });
    return atoms;
  });
}

std::vector<float> bytesOf(const Mapper& mapper) {
  return mapper.read([](const AtomMap& map) { return bytesOf(map); });
}

class Limits : public testing::TestWithParam<std::tuple<Mode, std::uint32_t>> {
 protected:
  Limits() {
    parameters_.mode = std::get<0>(GetParam());
    parameters_.seed = std::get<1>(GetParam());
    parameters_.radius = 0.4;
    parameters_.scan.max_range = kRange;
    parameters_.scan.horizontal_resolution = 1.5;
  }

  // Of an atom, from where the sensor was at a scan.
  double distance(const Mapper& mapper, const Center& center, std::size_t scan) const {
    const Vector3f local =
        mapper.read([&](const AtomMap& map) { return map.toLocal(corridor().poses[scan].translation()); });
    return static_cast<double>((Vector3f(center[0], center[1], center[2]) - local).norm());
  }

  // Calls check(scan, report, atoms before) after each scan.
  template <class Check>
  void drive(Mapper& mapper, Check&& check) const {
    for (std::size_t i = 0; i < corridor().scans.size(); ++i) {
      const Atoms before = atomsOf(mapper);
      const ScanReport report = mapper.insertScan(corridor().scans[i], corridor().poses[i]);
      check(i, report, before);
    }
  }

  std::size_t unlimitedSize() const {
    MappingParameters parameters = parameters_;
    parameters.limits = {};
    Mapper mapper(parameters);
    drive(mapper, [](std::size_t, const ScanReport& report, const Atoms&) {
      EXPECT_EQ(report.merge.refused + report.forgotten, 0U);
    });
    return mapper.read([](const AtomMap& map) { return map.atoms().size(); });
  }

  void expectHeld(const Mapper& mapper) const {
    const MapLimit limit = limitOf(parameters_.limits);
    mapper.read([&](const AtomMap& map) {
      EXPECT_LE(map.atoms().size(), limit.atoms);
      EXPECT_LE(map.atoms().bytes(), limit.bytes);
    });
  }

  MappingParameters parameters_;
};

TEST_P(Limits, AFullMapRefusesNewAtomsAndKeepsTheOthersUpToDate) {
  const std::size_t all = unlimitedSize();
  for (const bool by_bytes : {false, true}) {
    parameters_.limits = {};
    if (!by_bytes) parameters_.limits.max_atoms = static_cast<std::uint32_t>(all / 2);
    if (by_bytes) parameters_.limits.max_megabytes = 12e-6 * static_cast<double>(all);
    Mapper mapper(parameters_);
    std::uint64_t refused = 0;
    std::size_t updates_when_full = 0;
    drive(mapper, [&](std::size_t, const ScanReport& report, const Atoms& before) {
      expectHeld(mapper);
      const Atoms after = atomsOf(mapper);
      EXPECT_EQ(after.size(), before.size() + report.merge.inserted);
      for (const auto& atom : before) ASSERT_EQ(after.count(atom.first), 1U) << "a map that refuses removes nothing";
      if (report.merge.inserted == 0) updates_when_full += after != before ? 1 : 0;
      refused += report.merge.refused;
      EXPECT_EQ(report.forgotten, 0U);
    });
    EXPECT_GT(refused, all / 10);
    EXPECT_GE(updates_when_full, 1U);
    EXPECT_GT(atomsOf(mapper).size(), all / 4);
  }
}

TEST_P(Limits, ALimitThatIsNotReachedChangesNothing) {
  Mapper unlimited(parameters_);
  drive(unlimited, [](auto&&...) {});
  for (const LimitPolicy policy : {LimitPolicy::kRefuse, LimitPolicy::kForgetFarthest}) {
    parameters_.limits = {static_cast<std::uint32_t>(atomsOf(unlimited).size()), 1000.0, policy, 1000.0};
    Mapper mapper(parameters_);
    drive(mapper, [](std::size_t, const ScanReport& report, const Atoms&) {
      EXPECT_EQ(report.merge.refused + report.forgotten, 0U);
    });
    EXPECT_EQ(bytesOf(mapper), bytesOf(unlimited));
  }
}

TEST_P(Limits, AForgetfulMapForgetsTheFarthestAndNoMoreThanItMust) {
  const std::size_t all = unlimitedSize();
  for (const bool by_bytes : {false, true}) {
    parameters_.limits = {};
    parameters_.limits.policy = LimitPolicy::kForgetFarthest;
    if (!by_bytes) parameters_.limits.max_atoms = static_cast<std::uint32_t>(all / 3);
    if (by_bytes) parameters_.limits.max_megabytes = 10e-6 * static_cast<double>(all);
    Mapper mapper(parameters_);
    std::size_t least = all;
    int scans_that_forgot = 0;
    drive(mapper, [&](std::size_t scan, const ScanReport& report, const Atoms& before) {
      expectHeld(mapper);
      EXPECT_EQ(report.merge.refused, 0U);
      const Atoms after = atomsOf(mapper);
      EXPECT_EQ(after.size(), before.size() + report.merge.inserted - report.forgotten);
      if (report.forgotten == 0) return;
      ++scans_that_forgot;
      least = std::min(least, after.size());
      double farthest_kept = 0.0;
      for (const auto& atom : after) farthest_kept = std::max(farthest_kept, distance(mapper, atom.first, scan));
      for (const auto& atom : before) {
        ASSERT_TRUE(after.count(atom.first) == 1 || distance(mapper, atom.first, scan) >= farthest_kept - 1e-4);
      }
    });
    EXPECT_GT(scans_that_forgot, 3);
    EXPECT_LT(scans_that_forgot, kScans) << "each scan that forgets makes room for some";
    EXPECT_GE(least, by_bytes ? all / 5 : all / 3 * 94 / 100);
  }
}

TEST_P(Limits, AWindowKeepsWhatTheWholeMapHasThereAndNothingBeyond) {
  parameters_.limits.window = kRange + 4.0 * parameters_.radius + parameters_.rays.normal_distance;
  Mapper windowed(parameters_);
  MappingParameters without = parameters_;
  without.limits = {};
  Mapper whole(without);
  std::uint64_t forgotten = 0;
  drive(windowed, [&](std::size_t scan, const ScanReport& report, const Atoms&) {
    whole.insertScan(corridor().scans[scan], corridor().poses[scan]);
    forgotten += report.forgotten;
    const Atoms kept = atomsOf(windowed);
    const Atoms all = atomsOf(whole);
    for (const auto& [center, values] : kept) {
      ASSERT_LE(distance(windowed, center, scan), (1.0 + kWindowSlack) * parameters_.limits.window + 1e-3);
      ASSERT_EQ(all.at(center), values);
    }
    for (const auto& atom : all) {
      const bool is_in = distance(windowed, atom.first, scan) < parameters_.limits.window - 1e-3;
      ASSERT_TRUE(!is_in || kept.count(atom.first) == 1);
    }
  });
  EXPECT_EQ(forgotten, atomsOf(whole).size() - atomsOf(windowed).size());
  EXPECT_GT(forgotten, 1000U);
}

TEST_P(Limits, AWindowKeepsMemoryConstantOnALongDrive) {
  parameters_.limits.window = kRange;
  Mapper mapper(parameters_);
  std::array<std::uint64_t, 2> most{};  // bytes, in the second and the last quarter
  drive(mapper, [&](std::size_t scan, const ScanReport& report, const Atoms&) {
    if (scan / 10 == 1) most[0] = std::max(most[0], report.map_bytes);
    if (scan / 10 == 3) most[1] = std::max(most[1], report.map_bytes);
  });
  EXPECT_LE(static_cast<double>(most[1]), 1.1 * static_cast<double>(most[0]));
}

TEST_P(Limits, TheSameScansGiveTheSameBytesAndResetStartsAnew) {
  parameters_.limits = {1500, 0.0, LimitPolicy::kForgetFarthest, 14.0};
  Mapper first(parameters_);
  Mapper second(parameters_);
  drive(first, [](auto&&...) {});
  drive(second, [](auto&&...) {});
  EXPECT_FALSE(bytesOf(first).empty());
  EXPECT_EQ(bytesOf(first), bytesOf(second));
  second.reset();
  drive(second, [](auto&&...) {});
  EXPECT_EQ(bytesOf(first), bytesOf(second));
}

// As after a map file, which holds the atoms in their order and what the last scan tells the next.
TEST_P(Limits, AMapThatIsMadeAnewOfItsAtomsGoesOnAsIfItHadNeverStopped) {
  parameters_.limits = {1500, 0.0, LimitPolicy::kForgetFarthest, 14.0};
  Mapper whole(parameters_);
  Mapper stopped(parameters_);
  drive(whole, [&](std::size_t scan, const ScanReport&, const Atoms&) {
    stopped.insertScan(corridor().scans[scan], corridor().poses[scan]);
    AtomMap anew(parameters_.mode, parameters_.radius);
    stopped.read([&](const AtomMap& map) {
      anew.anchor(map.origin());
      anew.planes() = map.planes();
      map.atoms().forEach([&](ConstAtomRef atom) {
        const std::array<float, 2> values{atom.value(), map.mode() == Mode::kOccupancy ? 0.0F : atom.value(1)};
        anew.atoms().insert(atom.center(), values.data());
      });
    });
    stopped.replace(std::move(anew), scan + 1);
    ASSERT_EQ(bytesOf(stopped), bytesOf(whole));
  });
}

INSTANTIATE_TEST_SUITE_P(ModesAndSeeds, Limits,
                         testing::Combine(testing::Values(Mode::kOccupancy, Mode::kSignedDistance),
                                          testing::Values(1U, 2U, 3U)),
                         [](const auto& instance) {
                           const bool occupancy = std::get<0>(instance.param) == Mode::kOccupancy;
                           return std::string(occupancy ? "occupancy" : "distance") + "_seed_" +
                                  std::to_string(std::get<1>(instance.param));
                         });

TEST(LimitFaults, AWindowThatRaysReachBeyondIsNamedWithTheRemedy) {
  MappingParameters parameters;
  parameters.limits.window = 10.0;
  const std::vector<std::string> faults = findFaults(parameters);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0],
            "limits/window is 10; it must be 0 or at least scan/max_range, which is 25: lower that for a "
            "smaller window");
  parameters.scan.max_range = 10.0;
  EXPECT_TRUE(findFaults(parameters).empty());
}

}  // namespace
}  // namespace atom_map
