// What the tests of maps with limits share: a long drive, and what is looked at after each of its scans.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "atom_mapping/map/map_limit.h"
#include "atom_mapping/map/mapper.h"
#include "check_map.h"
#include "simulated.h"

namespace atom_map {

constexpr double kRange = 12.0;  // m
constexpr int kScans = 40;

// A corridor of 300 m with a column every 7 m; the sensor drives straight through it, and sees no place again that it left
// farther than its range behind.
inline const Drive& corridor() {
  static const Drive drive = [] {
    std::vector<Solid> solids{
        {makeBox(Pose(Eigen::Translation3d(140.0, 0.0, 1.0)), {300.0, 8.0, 5.0}), SurfaceKind::kWall, true}};
    for (int i = 0; i < 40; ++i) {
      const double side = i % 2 == 0 ? 2.5 : -2.5;
      solids.push_back({Cylinder{{7.0 * i, side, -1.5}, 0.3, 5.0}, SurfaceKind::kColumn});
    }
    Drive made{
        "corridor", Scene("corridor", std::move(solids), Eigen::AlignedBox3d(Eigen::Vector3d::Zero())), {}, {}, {}};
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

inline Atoms atomsOf(const Mapper& mapper) {
  return mapper.read([](const AtomMap& map) {
    Atoms atoms;
    map.atoms().forEach([&](ConstAtomRef atom) {
      const Eigen::Vector3f c = atom.center();
      atoms[{c.x(), c.y(), c.z()}] = {atom.value(), map.mode() == Mode::kOccupancy ? 0.0F : atom.value(1)};
    });
    return atoms;
  });
}

inline std::vector<float> bytesOf(const Mapper& mapper) {
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
    const Eigen::Vector3f local =
        mapper.read([&](const AtomMap& map) { return map.toLocal(corridor().poses[scan].translation()); });
    return static_cast<double>((Eigen::Vector3f(center[0], center[1], center[2]) - local).norm());
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

inline auto modesAndSeeds() {
  return testing::Combine(testing::Values(Mode::kOccupancy, Mode::kSignedDistance), testing::Values(1U, 2U, 3U));
}

inline std::string nameOf(const testing::TestParamInfo<std::tuple<Mode, std::uint32_t>>& instance) {
  const bool occupancy = std::get<0>(instance.param) == Mode::kOccupancy;
  return std::string(occupancy ? "occupancy" : "distance") + "_seed_" + std::to_string(std::get<1>(instance.param));
}

}  // namespace atom_map
