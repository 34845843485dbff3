// The comparison itself, on maps with a known answer.
#include "atom_mapping/evaluation/comparison.h"

#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "atom_mapping/evaluation/heap_in_use.h"
#include "simulated.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.2;
constexpr std::size_t kHeld = 100000;  // bytes a scan

// Answers always the same way, and holds so many bytes more with each scan. Notes its name at each scan.
ComparedMap makeFake(const std::string& name, const AskOccupancy& ask, std::vector<std::string>& order) {
  const auto held = std::make_shared<std::vector<std::unique_ptr<char[]>>>();
  return {name,
          [=, &order](const LidarScan&, const Pose&) {
            order.push_back(name);
            held->push_back(std::make_unique<char[]>(kHeld));
            ScanReport report;
            report.seconds.merge = 0.5;
            return report;
          },
          ask, [=] { return held->size(); }, [=] { held->clear(); }};
}

// The rays of one scan of the cube of 2 m, as recorded.
std::vector<ObservedRay> raysInCube() {
  const SimulatedScan scan = scanFromOrigin({makeRoom(1.0)}, LidarModel());
  std::vector<ObservedRay> rays;
  addRays(toLidarScan(scan), Pose::Identity(), ScanParameters(), 1, rays);
  return rays;
}

class ComparisonOfFakes : public testing::Test {
 protected:
  void SetUp() override {
    const auto truth = [](const Vector3d& p) {
      return p.lpNorm<Eigen::Infinity>() < 1.0 ? Occupancy::kFree : Occupancy::kOccupied;
    };
    Comparison comparison({makeFake(
                               "free", [](const Vector3d&) { return Occupancy::kFree; }, order_),
                           makeFake(
                               "unknown", [](const Vector3d&) { return Occupancy::kUnknown; }, order_),
                           makeFake("perfect", truth, order_)},
                          3);
    for (int i = 0; i < 4; ++i) comparison.insertScan({}, Pose::Identity());
    ASSERT_EQ(comparison.scans(), 4U);
    figures_ = comparison.finish(raysInCube(), kRadius);
    ASSERT_EQ(figures_.size(), 3U);
  }

  std::vector<std::string> order_;
  std::vector<MapFigures> figures_;
};

TEST_F(ComparisonOfFakes, EveryMapGetsEveryScanInTurnsThatAnotherOneBegins) {
  EXPECT_EQ(order_, (std::vector<std::string>{"free", "free", "free", "unknown", "unknown", "unknown", "perfect",
                                              "perfect", "perfect", "unknown", "perfect", "free"}));
}

TEST_F(ComparisonOfFakes, CoverageIsThatOfTheAnswers) {
  EXPECT_EQ(figures_[0].coverage.free.value(), 1.0);
  EXPECT_EQ(figures_[0].coverage.surface.value(), 0.0);
  EXPECT_EQ(figures_[1].coverage.unknown.value(), 1.0);
  EXPECT_EQ(figures_[1].coverage.surface.value(), 0.0);
  EXPECT_EQ(figures_[2].coverage.free.value(), 1.0);
  EXPECT_EQ(figures_[2].coverage.surface.value(), 1.0);
  EXPECT_GT(figures_[2].coverage.free.whole, 1000U);
}

TEST_F(ComparisonOfFakes, BytesAreTheHeapThatAMapHeld) {
  for (const MapFigures& figures : figures_) {
    EXPECT_NEAR(static_cast<double>(figures.bytes), 4.0 * kHeld, 0.02 * 4.0 * kHeld);
    EXPECT_EQ(figures.units, 4U);
  }
}

TEST_F(ComparisonOfFakes, JsonHoldsEveryFigure) {
  const nlohmann::json json = toJson(figures_[2]);
  EXPECT_EQ(json.at("name"), "perfect");
  EXPECT_DOUBLE_EQ(json.at("stages").at("merge"), 500.0) << "milliseconds a scan";
  EXPECT_EQ(json.at("stages").size(), 6U);
  EXPECT_EQ(json.at("ms_per_scan").at("p95"), figures_[2].milliseconds.p95);
  EXPECT_EQ(json.at("bytes"), figures_[2].bytes);
  EXPECT_EQ(json.at("surface"), 1.0);
  EXPECT_EQ(json.size(), 10U);
}

TEST(HeapReleased, IsWhatSmallBlocksTook) {
  std::vector<std::unique_ptr<char[]>> blocks;
  // 1008 bytes each with the header; 1024 where what is left of a freed block is too small to be a block.
  for (int i = 0; i < 1000; ++i) blocks.push_back(std::make_unique<char[]>(1000));
  const std::size_t released = heapReleasedBy([&] { blocks.clear(); });
  EXPECT_GE(released, 1000000U);
  EXPECT_LE(released, 1024000U);
}

TEST(ComparedMaps, ReleasingOneEmptiesItAndGivesItsMemoryBack) {
  for (ComparedMap map :
       {makeAtomMap({}, Mode::kOccupancy), makeAtomMap({}, Mode::kSignedDistance), makeOctomap({}, {})}) {
    SCOPED_TRACE(map.name);
    const LidarScan scan = toLidarScan(scanFromOrigin({makeRoom(5.0)}, LidarModel()));
    std::vector<ObservedRay> rays;
    addRays(scan, Pose::Identity(), ScanParameters(), 1, rays);
    map.insert_scan(scan, Pose::Identity());
    const Coverage coverage = measureCoverage(rays, MappingParameters().radius, map.ask, {}, 1);
    EXPECT_GT(coverage.free.value(), 0.3);
    EXPECT_GT(coverage.surface.value(), 0.6);
    EXPECT_EQ(map.ask({20.0, 0.0, 0.0}), Occupancy::kUnknown);
    const std::uint64_t units = map.units();
    EXPECT_GT(units, 100U);
    EXPECT_GT(heapReleasedBy(map.release), 16U * units);
    EXPECT_EQ(map.units(), 0U);
  }
}

}  // namespace
}  // namespace atom_map
