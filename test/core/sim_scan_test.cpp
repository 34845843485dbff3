#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "atom_mapping/sim/make_scene.h"
#include "atom_mapping/sim/simulate_scan.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

class SimScan : public testing::Test {
 protected:
  SimulatedScan scanAt(double stamp, std::uint64_t seed = 1) const {
    return simulateScan(scene_, trajectory_, stamp, model_, seed);
  }

  const Scene scene_ = makeScene("campus");
  const Trajectory trajectory_ = makeTrajectory("campus");
  LidarModel model_;
};

bool isSame(const SimulatedReturn& a, const SimulatedReturn& b) {
  return a.point == b.point && a.true_point == b.true_point && a.true_normal == b.true_normal && a.kind == b.kind &&
         a.intensity == b.intensity && a.time == b.time && a.ring == b.ring && a.firing == b.firing;
}

TEST_F(SimScan, SameSeedGivesTheSameBytesAndAnotherSeedOthers) {
  model_.dropout = 0.1;
  const SimulatedScan first = scanAt(0.3);
  const SimulatedScan second = scanAt(0.3);
  ASSERT_EQ(first.returns.size(), second.returns.size());
  for (std::size_t i = 0; i < first.returns.size(); ++i) ASSERT_TRUE(isSame(first.returns[i], second.returns[i]));
  EXPECT_FALSE(isSame(first.returns[0], scanAt(0.3, 2).returns[0]));
}

TEST_F(SimScan, NoiseOfTheRangeIsGaussianWithTheStatedSigma) {
  model_.noise_sigma = 0.05;
  double sum = 0.0;
  double squares = 0.0;
  double within_sigma = 0.0;
  double count = 0.0;
  for (int i = 0; i < 10; ++i) {
    for (const SimulatedReturn& r : scanAt(0.1 * i).returns) {
      const double noise = r.point.cast<double>().norm() - r.true_point.cast<double>().norm();
      EXPECT_LT(r.point.normalized().cross(r.true_point.normalized()).norm(), 1e-5F);
      sum += noise;
      squares += noise * noise;
      within_sigma += std::abs(noise) < 0.05 ? 1.0 : 0.0;
      count += 1.0;
    }
  }
  EXPECT_NEAR(sum / count, 0.0, 5.0 * 0.05 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.05, 0.05 * 0.01);
  EXPECT_NEAR(within_sigma / count, 0.6827, 0.005);
}

TEST_F(SimScan, TrueHitsLieOnTheSceneInThePoseOfTheirMoment) {
  for (const bool distorted : {false, true}) {
    model_.motion_distortion = distorted;
    const double stamp = 12.0;
    for (const SimulatedReturn& r : scanAt(stamp).returns) {
      const Pose pose = trajectory_.sensorPose(stamp + static_cast<double>(r.time));
      const Nearest nearest = scene_.nearest(pose * r.true_point.cast<double>());
      EXPECT_NEAR(nearest.distance, 0.0, 2e-5);
      EXPECT_LT(r.true_normal.dot(r.true_point), 0.0F);
      EXPECT_NEAR(r.true_normal.norm(), 1.0F, 1e-5F);
    }
  }
}

TEST_F(SimScan, TimesCountBackFromTheStamp) {
  for (const SimulatedReturn& r : scanAt(1.0).returns) EXPECT_EQ(r.time, 0.0F);
  model_.motion_distortion = true;
  const SimulatedScan scan = scanAt(1.0);
  EXPECT_NEAR(scan.returns.front().time, -0.1F, 1e-3F);
  EXPECT_NEAR(scan.returns.back().time, 0.0F, 1e-3F);
}

TEST_F(SimScan, EveryShotIsAccountedForOnce) {
  model_.dropout = 0.2;
  const SimulatedScan scan = scanAt(0.0);
  std::set<int> shots;
  for (const SimulatedReturn& r : scan.returns) shots.insert(r.firing * 16 + r.ring);
  for (const SimulatedNoReturn& r : scan.no_returns) shots.insert(r.firing * 16 + r.ring);
  EXPECT_EQ(shots.size(), 28800U);
  EXPECT_EQ(scan.returns.size() + scan.no_returns.size(), 28800U);
}

TEST_F(SimScan, DropoutLosesItsShareOfTheReturns) {
  const auto all = static_cast<double>(scanAt(0.0).returns.size());
  model_.dropout = 0.25;
  EXPECT_NEAR(static_cast<double>(scanAt(0.0).returns.size()) / all, 0.75, 0.02);
  model_.dropout = 1.0;
  EXPECT_TRUE(scanAt(0.0).returns.empty());
}

TEST_F(SimScan, RingsLieAtTheirElevationsAndFiringsInOrder) {
  const SimulatedScan scan = scanAt(0.0);
  int firing = 0;
  for (const SimulatedReturn& r : scan.returns) {
    const double elevation = std::asin(r.true_point.z() / r.true_point.norm()) * 180.0 / M_PI;
    EXPECT_NEAR(elevation, -15.0 + 2.0 * r.ring, 1e-3);
    EXPECT_GE(r.firing, firing);
    firing = r.firing;
  }
}

TEST_F(SimScan, RangesKeepWithinTheModelsLimits) {
  model_.noise_sigma = 0.0;
  model_.min_range = 5.0;
  model_.max_range = 20.0;
  for (const SimulatedReturn& r : scanAt(0.0).returns) {
    EXPECT_GE(r.true_point.norm(), 4.999F);
    EXPECT_LE(r.true_point.norm(), 20.001F);
    EXPECT_EQ(r.point, r.true_point);
  }
}

TEST_F(SimScan, AMapperSeesThePointsAndTheDirectionsWithoutEcho) {
  const SimulatedScan scan = scanAt(0.0);
  const LidarScan plain = toLidarScan(scan);
  ASSERT_EQ(plain.points.size(), scan.returns.size());
  ASSERT_EQ(plain.no_returns.size(), scan.no_returns.size());
  EXPECT_EQ(plain.points[7], scan.returns[7].point);
  EXPECT_EQ(plain.no_returns[7], scan.no_returns[7].direction);
}

TEST_F(SimScan, TenSecondsSeePolesAndTrunksInHallAndCampus) {
  for (const char* name : {"hall", "campus"}) {
    int thin = 0;
    for (int i = 0; i < 10; ++i) {
      const SimulatedScan scan = simulateScan(makeScene(name), makeTrajectory(name), 1.0 * i, model_, 1);
      for (const SimulatedReturn& r : scan.returns) thin += isThin(r.kind) ? 1 : 0;
    }
    EXPECT_GT(thin, 1000) << name;
  }
}

}  // namespace
}  // namespace atom_map
