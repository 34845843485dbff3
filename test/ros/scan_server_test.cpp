#include "atom_mapping/ros/scan_server.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <stdexcept>

#include "atom_mapping/query/occupancy.h"
#include "atom_mapping/ros/transform_memory.h"
#include "simulated_input.h"

namespace atom_mapping {
namespace {

// Every atom's bytes, in the tree's order.
std::string bytesOf(const ScanServer& server) {
  std::string bytes;
  server.read([&](const atom_map::AtomMap& map) {
    map.atoms().forEach([&](atom_map::ConstAtomRef atom) {
      const std::array<float, 4> all{atom.center().x(), atom.center().y(), atom.center().z(), atom.value()};
      bytes.append(reinterpret_cast<const char*>(all.data()), sizeof all);
    });
  });
  return bytes;
}

class ScanServerTest : public testing::Test {
 protected:
  void tellTransform(int i) { ASSERT_TRUE(transforms_.setTransform(drive_.transform(i), "test")); }

  ScanOutcome insert(const sensor_msgs::PointCloud2& cloud) { return server_.insert(cloud, transforms_); }

  void expectDrop(Drop cause, const sensor_msgs::PointCloud2& cloud, const std::string& message) {
    const std::string before = bytesOf(server_);
    const std::uint64_t count = server_.counts().droppedFor(cause);
    const ScanOutcome outcome = insert(cloud);
    ASSERT_TRUE(outcome.drop);
    EXPECT_STREQ(toString(*outcome.drop), toString(cause));
    EXPECT_NE(outcome.message.find(message), std::string::npos) << outcome.message;
    EXPECT_EQ(server_.counts().droppedFor(cause), count + 1);
    EXPECT_EQ(server_.counts().last_drop, outcome.message);
    EXPECT_EQ(bytesOf(server_), before);
  }

  const SimulatedDrive drive_ = makeCoarseDrive();
  tf2::BufferCore transforms_;
  ScanServer server_{atom_map::MappingParameters()};
};

TEST_F(ScanServerTest, MapsFromWhereTfSaysTheSensorWas) {
  tellTransform(0);
  const auto cloud = drive_.cloud(0);
  const ScanOutcome outcome = insert(cloud);
  ASSERT_FALSE(outcome.drop) << outcome.message;
  EXPECT_EQ(outcome.report.header, cloud.header);
  EXPECT_EQ(outcome.report.points_in, cloud.width);
  EXPECT_EQ(outcome.report.points_in, outcome.report.dropped_nan + outcome.report.dropped_too_near +
                                          outcome.report.dropped_too_far + outcome.report.dropped_no_return +
                                          outcome.report.dropped_thinned + outcome.report.surface_points);
  EXPECT_GT(outcome.report.atoms, 100U);
  EXPECT_EQ(server_.counts().mapped, 1U);
  EXPECT_EQ(server_.counts().droppedInAll(), 0U);
  EXPECT_EQ(server_.newest(), cloud.header.stamp);

  atom_map::Mapper direct{atom_map::MappingParameters()};
  direct.insertScan(atom_map::toLidarScan(drive_.scan(0)), drive_.pose(0));
  EXPECT_EQ(outcome.report.atoms, direct.read([](const auto& map) { return map.atoms().size(); }));
}

TEST_F(ScanServerTest, ACloudThatWaitedForAMinuteToBeMappedStillHasItsTransform) {
  constexpr int kLater = 600;  // scans
  InputParameters input;
  for (const double timeout : {0.0, 60.0}) {
    input.transform_timeout = timeout;
    tf2::BufferCore transforms(transformMemory(input));
    ASSERT_TRUE(transforms.setTransform(drive_.transform(0), "test"));
    ASSERT_TRUE(transforms.setTransform(drive_.transform(kLater + static_cast<int>(10.0 * timeout)), "test"));
    const ScanOutcome outcome = server_.insert(drive_.cloud(0), transforms);
    EXPECT_FALSE(outcome.drop) << outcome.message;
  }
}

TEST_F(ScanServerTest, SameCloudsGiveTheSameBytes) {
  ScanServer other{atom_map::MappingParameters()};
  for (int i = 0; i < 5; ++i) {
    tellTransform(i);
    insert(drive_.cloud(i));
    other.insert(drive_.cloud(i), transforms_);
  }
  EXPECT_FALSE(bytesOf(server_).empty());
  EXPECT_EQ(bytesOf(server_), bytesOf(other));
}

TEST_F(ScanServerTest, LeadingSlashesOfOldDriversDoNoHarm) {
  tellTransform(0);
  auto cloud = drive_.cloud(0);
  cloud.header.frame_id = "/velodyne";
  EXPECT_FALSE(insert(cloud).drop);
}

TEST_F(ScanServerTest, MalformedCloudsAreDropped) {
  tellTransform(0);
  tellTransform(1);
  insert(drive_.cloud(0));
  for (const Fault& fault : malformations()) {
    SCOPED_TRACE(fault.name);
    auto cloud = drive_.cloud(1);
    fault.spoil(cloud);
    expectDrop(Drop::kMalformed, cloud, "malformed cloud: ");
  }
}

TEST_F(ScanServerTest, CloudsWithoutATransformAreDropped) {
  expectDrop(Drop::kNoTransform, drive_.cloud(0), "no transform from velodyne to map");
  tellTransform(0);
  expectDrop(Drop::kNoTransform, drive_.cloud(1), "extrapolation");
  auto cloud = drive_.cloud(0);
  cloud.header.frame_id = "nowhere";
  expectDrop(Drop::kNoTransform, cloud, "nowhere");
}

TEST_F(ScanServerTest, ATransformBeyondTheEarthIsDropped) {
  auto transform = drive_.transform(0);
  transform.transform.translation.x = 1e9;
  ASSERT_TRUE(transforms_.setTransform(transform, "test"));
  expectDrop(Drop::kBadTransform, drive_.cloud(0), "1e+09");
}

TEST_F(ScanServerTest, StampsThatJumpBackAreDroppedUntilTimeBeginsAnew) {
  for (int i = 0; i < 3; ++i) tellTransform(i);
  insert(drive_.cloud(2));
  expectDrop(Drop::kOutOfOrder, drive_.cloud(0), "out of order");
  expectDrop(Drop::kOutOfOrder, drive_.cloud(1), "out of order");
  EXPECT_FALSE(insert(drive_.cloud(2)).drop);  // the same moment again: another sensor's
  server_.restartTime();
  EXPECT_FALSE(insert(drive_.cloud(0)).drop);
  EXPECT_EQ(server_.counts().mapped, 3U);
}

TEST_F(ScanServerTest, EmptyCloudsAreMappedAndCounted) {
  tellTransform(0);
  sensor_msgs::PointCloud2 cloud;
  cloud.header = drive_.header(0, "velodyne");
  const ScanOutcome outcome = insert(cloud);
  EXPECT_FALSE(outcome.drop);
  EXPECT_EQ(outcome.report.points_in, 0U);
  EXPECT_EQ(server_.counts().mapped, 1U);
  EXPECT_EQ(server_.counts().empty, 1U);
}

TEST_F(ScanServerTest, PointsThatAreNotFiniteAreCounted) {
  tellTransform(0);
  auto cloud = drive_.cloud(0);
  const float nan = std::nanf("");
  const float inf = std::numeric_limits<float>::infinity();
  std::memcpy(&cloud.data[0], &nan, 4);
  std::memcpy(&cloud.data[cloud.point_step + 4], &inf, 4);
  const ScanOutcome outcome = insert(cloud);
  EXPECT_EQ(outcome.report.dropped_nan, 1U);
  EXPECT_EQ(outcome.report.dropped_no_return, 1U);
}

TEST_F(ScanServerTest, NoReturnsClearTheirRaysIfAsked) {
  atom_map::MappingParameters parameters;
  parameters.scan.clear_no_returns = true;
  parameters.scan.horizontal_resolution = 2.0;  // as the sensor below
  ScanServer clearing(parameters);
  SimulatedDrive blind = makeCoarseDrive();
  blind.model.max_range = 10.0;
  tellTransform(0);
  const auto scan = blind.scan(0);
  const auto cloud = atom_map::toOrganizedPointCloud2(scan, blind.model, blind.header(0, "velodyne"));
  insert(cloud);
  clearing.insert(cloud, transforms_);
  int freed = 0;
  int freed_by_default = 0;
  for (const auto& ray : scan.no_returns) {
    const Eigen::Vector3d point = blind.pose(0) * (8.0 * ray.direction.cast<double>());
    const auto is_free = [&](const atom_map::AtomMap& map) {
      return atom_map::classify(atom_map::interpolate(map, map.toLocal(point))) == atom_map::Occupancy::kFree;
    };
    freed += clearing.read(is_free) ? 1 : 0;
    freed_by_default += server_.read(is_free) ? 1 : 0;
  }
  const auto all = static_cast<int>(scan.no_returns.size());
  EXPECT_GT(all, 500);
  EXPECT_GT(freed, all * 6 / 10);
  EXPECT_LT(freed_by_default, freed / 2);
}

TEST_F(ScanServerTest, TheRevisionGrowsWithEveryChange) {
  EXPECT_EQ(server_.revision(), 0U);
  tellTransform(0);
  insert(drive_.cloud(0));
  EXPECT_EQ(server_.revision(), 1U);
  insert(sensor_msgs::PointCloud2());
  EXPECT_EQ(server_.revision(), 1U);
  const Eigen::AlignedBox3d everything(Eigen::Vector3d::Constant(-1e3), Eigen::Vector3d::Constant(1e3));
  EXPECT_GT(server_.clearRegion(everything), 100U);
  EXPECT_EQ(server_.revision(), 2U);
  EXPECT_TRUE(bytesOf(server_).empty());
  server_.reset();
  EXPECT_EQ(server_.revision(), 3U);
}

TEST_F(ScanServerTest, AResetServerBuildsTheSameMapAgain) {
  tellTransform(0);
  insert(drive_.cloud(0));
  const std::string first = bytesOf(server_);
  server_.reset();
  EXPECT_TRUE(bytesOf(server_).empty());
  insert(drive_.cloud(0));
  EXPECT_EQ(bytesOf(server_), first);
}

class LimitedServerTest : public ScanServerTest {
 protected:
  static constexpr std::uint32_t kMost = 300;  // atoms

  // Maps some clouds; returns the last report.
  ScanReport mapWith(atom_map::LimitPolicy policy) {
    atom_map::MappingParameters parameters;
    parameters.limits.max_atoms = kMost;
    parameters.limits.policy = policy;
    limited_ = std::make_unique<ScanServer>(parameters);
    ScanReport last;
    for (int i = 0; i < 3; ++i) {
      tellTransform(i);
      last = limited_->insert(drive_.cloud(i), transforms_).report;
      EXPECT_LE(last.atoms, kMost);
      refused_ += last.atoms_refused;
      forgotten_ += last.atoms_forgotten;
    }
    EXPECT_EQ(limited_->limitCounts().refused, refused_);
    EXPECT_EQ(limited_->limitCounts().forgotten, forgotten_);
    return last;
  }

  std::unique_ptr<ScanServer> limited_;
  std::uint64_t refused_ = 0;
  std::uint64_t forgotten_ = 0;
};

TEST_F(LimitedServerTest, AFullMapTellsWhatItRefusesUntilThereIsRoom) {
  const ScanReport last = mapWith(atom_map::LimitPolicy::kRefuse);
  EXPECT_GT(last.atoms_refused, 100U);
  EXPECT_EQ(last.atoms, kMost);
  EXPECT_EQ(forgotten_, 0U);
  EXPECT_TRUE(limited_->limitCounts().is_full);
  limited_->reset();
  EXPECT_FALSE(limited_->limitCounts().is_full);
  EXPECT_EQ(limited_->limitCounts().refused, refused_);
}

TEST_F(LimitedServerTest, AForgetfulMapTellsWhatItForgets) {
  const ScanReport last = mapWith(atom_map::LimitPolicy::kForgetFarthest);
  EXPECT_GT(last.atoms_forgotten, 100U);
  EXPECT_GT(last.seconds_forget, 0.0F);
  EXPECT_LE(last.seconds_forget, last.seconds_total);
  EXPECT_EQ(refused_, 0U);
  EXPECT_FALSE(limited_->limitCounts().is_full);
}

TEST(ScanServer, FaultyParametersAreRefused) {
  atom_map::MappingParameters parameters;
  parameters.radius = -1.0;
  EXPECT_THROW(ScanServer{parameters}, std::invalid_argument);
}

}  // namespace
}  // namespace atom_mapping
