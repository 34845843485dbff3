// Recordings of real sensors, mapped and held against their own rays. They lie beside the repository in ../shared/data,
// or where ATOM_MAPPING_DATA says; without them the tests are skipped.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "atom_mapping/base/spread.h"
#include "atom_mapping/query/occupancy_query.h"
#include "atom_mapping/ros/bag_reader.h"
#include "atom_mapping/ros/bag_summary.h"
#include "atom_mapping/ros/cloud_conversion.h"
#include "atom_mapping/ros/pose_conversion.h"
#include "atom_mapping/ros/scan_server.h"
#include "atom_mapping/sim/coverage.h"

namespace atom_mapping {
namespace {

namespace fs = std::filesystem;
using atom_map::AtomMap;
using atom_map::Coverage;
using atom_map::LidarScan;
using atom_map::ObservedRay;
using atom_map::Occupancy;
using atom_map::Pose;
using Eigen::Vector3d;

constexpr std::size_t kRayStride = 7;  // of the returns, every seventh is asked for

// What a recording must give at a radius: a little less than it did when this was written.
struct Recording {
  const char* name;
  std::size_t scans;
  double radius;   // m
  double free;     // shares, at least
  double surface;  // at least
  double unknown;  // at most
};

std::ostream& operator<<(std::ostream& out, const Recording& recording) {
  return out << recording.name << " at r = " << recording.radius;
}

fs::path dataFolder() {
  const char* const given = std::getenv("ATOM_MAPPING_DATA");
  return given != nullptr ? fs::path(given) : fs::path(__FILE__).parent_path() / "../../../shared/data";
}

class RecordedBags : public testing::TestWithParam<Recording> {
 protected:
  static void SetUpTestSuite() {
    if (!fs::exists(dataFolder())) return;
    std::printf("%-22s %5s %5s %7s %6s %6s %9s %6s %7s %8s %8s %10s\n", "bag", "r", "scans", "atoms", "ms", "95 %",
                "real time", "free", "unknown", "occupied", "surface", "2nd pass");
  }

  void SetUp() override {
    const fs::path file = dataFolder() / (std::string(GetParam().name) + ".bag");
    if (!fs::exists(file)) GTEST_SKIP() << "NO RECORDED DATA: " << file << " is missing; set ATOM_MAPPING_DATA";
    file_ = file.string();
    parameters_.radius = GetParam().radius;
  }

  // Maps the whole bag and calls visit(cloud, outcome) for each scan.
  template <class Visit>
  void map(ScanServer& server, Visit&& visit) const {
    BagReader bag(file_, "");
    while (const auto cloud = bag.next()) visit(*cloud, server.insert(*cloud, bag.transforms()), bag.transforms());
  }

  void addRays(const sensor_msgs::PointCloud2& cloud, const tf2::BufferCore& transforms) {
    const LidarScan scan = toLidarScan(cloud);
    const Pose pose = toPose(transforms.lookupTransform("map", cloud.header.frame_id, cloud.header.stamp).transform);
    atom_map::addRays(scan, pose, parameters_.scan, kRayStride, rays_);
  }

  Coverage coverageOf(const ScanServer& server) const {
    return server.mapper().read([&](const AtomMap& map) {
      atom_map::OccupancyQuery ask(map, parameters_.gaussian_process);
      return atom_map::measureCoverage(rays_, parameters_.radius, ask, {}, 1);
    });
  }

  std::string file_;
  atom_map::MappingParameters parameters_;
  std::vector<ObservedRay> rays_;
};

TEST_P(RecordedBags, MapAgreesWithItsOwnRays) {
  ScanServer server(parameters_);
  std::vector<double> milliseconds;
  std::vector<ros::Time> stamps;
  map(server, [&](const auto& cloud, const ScanOutcome& outcome, const auto& transforms) {
    ASSERT_FALSE(outcome.drop) << outcome.message;
    milliseconds.push_back(1e3 * static_cast<double>(outcome.report.seconds_total));
    stamps.push_back(cloud.header.stamp);
    addRays(cloud, transforms);
  });
  ASSERT_EQ(milliseconds.size(), GetParam().scans);
  const auto atoms = [&] { return server.mapper().read([](const AtomMap& map) { return map.atoms().size(); }); };
  const std::size_t first_pass = atoms();
  ASSERT_GT(first_pass, 0U);
  const Coverage coverage = coverageOf(server);

  server.restartTime();
  map(server, [&](const auto&, const ScanOutcome& outcome, const auto&) { ASSERT_FALSE(outcome.drop); });
  const double added = static_cast<double>(atoms() - first_pass) / static_cast<double>(first_pass);

  const atom_map::Spread time = atom_map::spreadOf(milliseconds);
  const double period = 1e3 * (stamps.back() - stamps.front()).toSec() / static_cast<double>(stamps.size() - 1);
  std::printf("%-22s %5.2f %5zu %7zu %6.1f %6.1f %9.1f %6.3f %7.3f %8.3f %8.3f %8.1f %%\n", GetParam().name,
              parameters_.radius, stamps.size(), first_pass, time.mean, time.p95, period / time.mean,
              coverage.free.value(), coverage.unknown.value(), coverage.false_occupied.value(),
              coverage.surface.value(), 100.0 * added);
  EXPECT_GE(coverage.free.value(), GetParam().free);
  EXPECT_GE(coverage.surface.value(), GetParam().surface);
  EXPECT_LE(coverage.unknown.value(), GetParam().unknown);
  EXPECT_LE(added, 0.13);
  if (parameters_.radius >= 0.25) {
    EXPECT_LT(time.mean, period) << "slower than real time";
  }
}

// Through the street things move: what was a surface is free some scans later, and the map follows.
// The fixed sensors stand among things as near as 0.5 m: at these radii atoms do not fit between, and around the sensor of
// vlp16_dual_return a single atom decides. At 0.1 m most do.
INSTANTIATE_TEST_SUITE_P(All, RecordedBags,
                         testing::Values(Recording{"handheld", 89, 0.5, 0.975, 0.97, 0.01},
                                         Recording{"handheld", 89, 0.25, 0.985, 0.96, 0.01},
                                         Recording{"street", 52, 0.5, 0.94, 0.88, 0.01},
                                         Recording{"street", 52, 0.25, 0.96, 0.85, 0.01},
                                         Recording{"vlp16_room", 4, 0.5, 0.58, 0.93, 0.04},
                                         Recording{"vlp16_room", 4, 0.25, 0.80, 0.93, 0.04},
                                         Recording{"vlp16_room", 4, 0.1, 0.93, 0.91, 0.04},
                                         Recording{"vlp16_dual_return", 4, 0.5, 0.05, 0.95, 0.05},
                                         Recording{"vlp16_dual_return", 4, 0.25, 0.15, 0.93, 0.15},
                                         Recording{"vlp16_dual_return", 4, 0.1, 0.82, 0.94, 0.04}));

}  // namespace
}  // namespace atom_mapping
