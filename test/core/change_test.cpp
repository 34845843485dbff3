// Change in the world: what was occupied becomes free once rays pass through it, and occupied again when it is back.
#include <gtest/gtest.h>

#include <deque>

#include "atom_mapping/map/mapper.h"
#include "atom_mapping/query/occupancy_query.h"
#include "simulated.h"

namespace atom_map {
namespace {

constexpr int kScansUntilTold = 12;  // as the README and docs/reliability.md promise

// A room with or without a box in it, seen from its middle; noise as the sensor has it.
LidarScan scanRoom(bool with_box, std::uint64_t seed) {
  std::vector<Solid> solids{makeRoom(8.0)};
  const Pose place(Eigen::Translation3d(4.0, 0.5, 0.0));
  if (with_box) solids.push_back({makeBox(place, {1.0, 1.5, 8.0}), SurfaceKind::kBox});
  const Scene scene("room", std::move(solids), Eigen::AlignedBox3d(Eigen::Vector3d::Zero()));
  Trajectory rest;
  rest.base_pose = [](double) { return Pose::Identity(); };
  return toLidarScan(simulateScan(scene, rest, 0.0, LidarModel{}, seed));
}

// The same scans in maps of several seeds.
class Change : public testing::TestWithParam<double> {
 protected:
  Change() {
    for (const std::uint32_t seed : {1U, 2U, 3U}) mappers_.emplace_back(parameters(seed));
  }

  static MappingParameters parameters(std::uint32_t seed) {
    MappingParameters parameters;
    parameters.radius = GetParam();
    parameters.seed = seed;
    return parameters;
  }

  void insertScans(int count, bool with_box) {
    for (int i = 0; i < count; ++i) {
      const LidarScan scan = scanRoom(with_box, ++seed_);
      for (Mapper& mapper : mappers_) mapper.insertScan(scan, Pose::Identity());
    }
  }

  // Of points just behind the front of the box, half a radius or more from its sides, past which rays go: the mean of all maps.
  double shareOfFront(Occupancy wanted) {
    const double margin = std::max(0.05, 0.5 * GetParam());
    int all = 0;
    int found = 0;
    for (Mapper& mapper : mappers_) {
      mapper.read([&](const AtomMap& map) {
        OccupancyQuery occupancy(map, mapper.parameters().gaussian_process);
        for (double y = -0.25 + margin; y <= 1.25 - margin; y += 0.05) {
          for (double z = -0.8; z <= 0.8; z += 0.05) {
            ++all;
            found += occupancy(Eigen::Vector3d(3.5 + std::min(GetParam(), 0.2), y, z)) == wanted ? 1 : 0;
          }
        }
      });
    }
    return static_cast<double>(found) / all;
  }

  std::deque<Mapper> mappers_;
  std::uint64_t seed_ = 0;
};

TEST_P(Change, ABoxThatIsGoneIsFreeAndOneThatIsBackIsOccupiedWithinTwelveScans) {
  insertScans(25, true);
  ASSERT_GE(shareOfFront(Occupancy::kOccupied), 0.98);
  insertScans(kScansUntilTold, false);
  EXPECT_GE(shareOfFront(Occupancy::kFree), 0.99);
  insertScans(20, false);
  EXPECT_GE(shareOfFront(Occupancy::kFree), 0.995);
  insertScans(kScansUntilTold, true);
  EXPECT_GE(shareOfFront(Occupancy::kOccupied), 0.98);
}

INSTANTIATE_TEST_SUITE_P(Radii, Change, testing::Values(0.15, 0.25, 0.5));

}  // namespace
}  // namespace atom_map
