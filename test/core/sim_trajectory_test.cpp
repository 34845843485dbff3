#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "atom_mapping/base/random.h"
#include "atom_mapping/sim/make_scene.h"
#include "atom_mapping/sim/simulate_scan.h"
#include "atom_mapping/sim/trajectory.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

constexpr double kLongDrive = 240.0;  // s, more than one loop of every scene

class SimTrajectories : public testing::TestWithParam<std::string> {
 protected:
  const Scene scene_ = makeScene(GetParam());
  const Trajectory trajectory_ = makeTrajectory(GetParam());

  Vector3d velocityAt(double time) const {
    return (trajectory_.sensorPose(time + 1e-4).translation() - trajectory_.sensorPose(time).translation()) / 1e-4;
  }
};

TEST_P(SimTrajectories, StaysClearOfEverySurface) {
  for (double time = -1.0; time < kLongDrive; time += 0.05) {
    EXPECT_GE(scene_.signedDistance(trajectory_.sensorPose(time).translation()), 0.6) << time;
  }
}

TEST_P(SimTrajectories, IsSmooth) {
  for (double time = -1.0; time < kLongDrive; time += 0.05) {
    EXPECT_LT((velocityAt(time + 0.05) - velocityAt(time)).norm(), 0.05) << time;
    const Pose step = trajectory_.sensorPose(time).inverse() * trajectory_.sensorPose(time + 0.05);
    EXPECT_LT(Eigen::AngleAxisd(step.linear()).angle(), 0.1) << time;
  }
}

INSTANTIATE_TEST_SUITE_P(All, SimTrajectories, testing::ValuesIn(sceneNames()),
                         [](const auto& instance) { return instance.param; });

class SimDrives : public SimTrajectories {};

TEST_P(SimDrives, GoAtWalkingPaceWithTheSensorAtItsHeight) {
  for (double time = 0.0; time < kLongDrive; time += 0.05) {
    EXPECT_GT(velocityAt(time).norm(), 0.6) << time;
    EXPECT_LT(velocityAt(time).norm(), 1.6) << time;
    const auto ground = scene_.castRay(trajectory_.sensorPose(time).translation(), -Vector3d::UnitZ(), 10.0);
    ASSERT_TRUE(ground);
    EXPECT_GT(ground->range, 1.2) << time;
    EXPECT_LT(ground->range, 1.8) << time;
  }
}

TEST_P(SimDrives, HaveAMountThatIsNotLevel) {
  const double tilt = std::acos(trajectory_.mount.linear()(2, 2));
  EXPECT_GT(tilt, 0.03);
  EXPECT_LT(tilt, 0.1);
}

INSTANTIATE_TEST_SUITE_P(All, SimDrives, testing::Values("hall", "campus"),
                         [](const auto& instance) { return instance.param; });

class SimTumbles : public SimTrajectories {};

TEST_P(SimTumbles, FortyScansSeeTheWholeClosedSurface) {
  std::vector<Vector3d> seen;
  for (int i = 0; i < 40; ++i) {
    const Pose pose = trajectory_.sensorPose(0.1 * i);
    const SimulatedScan scan = simulateScan(scene_, trajectory_, 0.1 * i, LidarModel{}, 1);
    for (std::size_t k = 0; k < scan.returns.size(); k += 23) {
      seen.push_back(pose * scan.returns[k].true_point.cast<double>());
    }
  }
  Random random(4);
  const auto draw = [&] { return 2.0 * static_cast<double>(random.uniform()) - 1.0; };
  for (int i = 0; i < 500; ++i) {
    const double x = draw();
    const double y = draw();
    const auto wall = scene_.castRay(Vector3d::Zero(), Vector3d(x, y, draw()).normalized(), 3.0);
    ASSERT_TRUE(wall);
    const auto is_near = [&](const Vector3d& point) { return (point - wall->point).norm() < 0.12; };
    EXPECT_TRUE(std::any_of(seen.begin(), seen.end(), is_near)) << wall->point.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(All, SimTumbles, testing::Values("cube", "cube_rotated", "sphere"),
                         [](const auto& instance) { return instance.param; });

TEST(SimTrajectory, UnknownSceneThrows) {
  EXPECT_THROW(makeTrajectory("moon"), std::invalid_argument);
}

}  // namespace
}  // namespace atom_map
