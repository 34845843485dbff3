// What holds of every map, over scenes and seeds.
#include "atom_mapping/map/mapper.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "check_map.h"
#include "simulated.h"

namespace atom_map {
namespace {

constexpr double kMaxLogOdds = 3.5;
constexpr int kFirings = 600;  // a third of a VLP-16's, to save time

MappingParameters parametersOf(const std::string& scene, std::uint32_t seed) {
  MappingParameters parameters;
  parameters.radius = scene == "hall" ? 0.5 : 0.1;  // the closed scenes are 2 m wide
  parameters.seed = seed;
  parameters.scan.min_range = 0.1;
  parameters.scan.horizontal_resolution = 360.0 / kFirings;
  parameters.occupancy.max_log_odds = kMaxLogOdds;
  return parameters;
}

// Simulated once, mapped by many tests.
const Drive& driveThrough(const std::string& scene) {
  static std::map<std::string, Drive> drives;
  LidarModel model;
  model.firings = kFirings;
  if (drives.count(scene) == 0) drives.emplace(scene, makeDrive(scene, 4, 6, model));
  return drives.at(scene);
}

void mapAll(Mapper& mapper, const Drive& drive, const Eigen::Vector3d& shift = Eigen::Vector3d::Zero()) {
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    mapper.insertScan(drive.scans[i], Eigen::Translation3d(shift) * drive.poses[i]);
  }
}

std::vector<float> bytesOf(const Mapper& mapper) {
  return mapper.read([](const AtomMap& map) { return bytesOf(map); });
}

std::size_t sizeOf(const Mapper& mapper) {
  return mapper.read([](const AtomMap& map) { return map.atoms().size(); });
}

class Mapping : public testing::TestWithParam<std::tuple<std::string, std::uint32_t>> {
 protected:
  const Drive& drive_ = driveThrough(std::get<0>(GetParam()));
  const MappingParameters parameters_ = parametersOf(std::get<0>(GetParam()), std::get<1>(GetParam()));
  Mapper mapper_{parameters_};
};

TEST_P(Mapping, KeepsAtomsApartAndLogOddsWithinTheClampsAfterEveryScan) {
  for (std::size_t i = 0; i < drive_.scans.size(); ++i) {
    mapper_.insertScan(drive_.scans[i], drive_.poses[i]);
    mapper_.read([](const AtomMap& map) {
      expectNoOverlap(map);
      expectWithinClamps(map, kMaxLogOdds);
    });
  }
}

TEST_P(Mapping, ReportsWhatItDid) {
  std::uint64_t atoms = 0;
  for (std::size_t i = 0; i < drive_.scans.size(); ++i) {
    const ScanReport report = mapper_.insertScan(drive_.scans[i], drive_.poses[i]);
    const FilterReport& filter = report.filter;
    EXPECT_EQ(filter.points_in, drive_.scans[i].points.size());
    EXPECT_EQ(filter.points_in - filter.nan - filter.no_return - filter.too_near - filter.too_far - filter.thinned,
              report.surface_points);
    EXPECT_GT(report.surface_points, 100U);
    EXPECT_GE(report.candidates_proposed, report.candidates_interleaved);
    EXPECT_GE(report.candidates_interleaved, report.candidates_kept);
    EXPECT_GE(report.candidates_kept, report.merge.inserted);
    EXPECT_GT(report.candidates_kept, 0U);
    EXPECT_EQ(report.atoms, atoms + report.merge.inserted);
    EXPECT_EQ(report.map_bytes, mapper_.read([](const AtomMap& map) { return map.atoms().bytes(); }));
    EXPECT_GT(report.seconds.total(), 0.0);
    atoms = report.atoms;
  }
  EXPECT_EQ(atoms, sizeOf(mapper_));
}

TEST_P(Mapping, SameScansAndSeedGiveTheSameBytesAndAnotherSeedOthers) {
  mapAll(mapper_, drive_);
  Mapper again(parameters_);
  mapAll(again, drive_);
  EXPECT_EQ(bytesOf(mapper_), bytesOf(again));
  MappingParameters others = parameters_;
  others.seed += 1;
  Mapper other(others);
  mapAll(other, drive_);
  EXPECT_NE(bytesOf(mapper_), bytesOf(other));
}

TEST_P(Mapping, ResetAndReplayGivesTheSameBytes) {
  mapAll(mapper_, drive_);
  const std::vector<float> first = bytesOf(mapper_);
  mapper_.reset();
  EXPECT_EQ(mapper_.read([](const AtomMap& map) { return map.atoms().size() + map.atoms().bytes(); }), 0U);
  mapAll(mapper_, drive_);
  EXPECT_EQ(bytesOf(mapper_), first);
}

TEST_P(Mapping, TheSameScansAgainAddFewAtoms) {
  mapAll(mapper_, drive_);
  const std::size_t first = sizeOf(mapper_);
  mapAll(mapper_, drive_);
  EXPECT_LT(sizeOf(mapper_) - first, 3 * first / 20);
}

// Interleaving leaves none of an overlapping set in (1 - 1.25 / k)^k = 29 % of cases: a hole, unless a neighbour stands aside
// into it, that a second look fills.
TEST_P(Mapping, OneScanOverAndOverAddsHardlyAnything) {
  const auto insert = [&] { return mapper_.insertScan(drive_.scans[0], drive_.poses[0]).merge.inserted; };
  const std::uint32_t first = insert();
  EXPECT_LT(insert(), 0.25 * first);
  for (int i = 0; i < 5; ++i) insert();
  EXPECT_LT(insert(), 0.04 * first);
}

TEST_P(Mapping, AHundredKilometresAwayGivesTheSameMapThere) {
  const Eigen::Vector3d shift(1e5, -2e5, 300.0);
  mapAll(mapper_, drive_);
  Mapper far(parameters_);
  mapAll(far, drive_, shift);
  const auto origin = [](const AtomMap& map) { return map.origin(); };
  EXPECT_EQ(far.read(origin), mapper_.read(origin) + shift);
  const std::vector<float> near_atoms = bytesOf(mapper_);
  const std::vector<float> far_atoms = bytesOf(far);
  ASSERT_EQ(near_atoms.size(), far_atoms.size());
  for (std::size_t i = 0; i < near_atoms.size(); ++i) ASSERT_NEAR(near_atoms[i], far_atoms[i], 1e-4F);
}

INSTANTIATE_TEST_SUITE_P(ScenesAndSeeds, Mapping,
                         testing::Combine(testing::Values("cube", "cube_rotated", "sphere", "hall"),
                                          testing::Values(1U, 2U)),
                         [](const auto& instance) {
                           return std::get<0>(instance.param) + "_seed_" + std::to_string(std::get<1>(instance.param));
                         });

}  // namespace
}  // namespace atom_map
