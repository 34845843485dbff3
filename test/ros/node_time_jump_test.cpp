#include <rosgraph_msgs/Clock.h>

#include "atom_mapping/QueryOccupancy.h"
#include "node_client.h"

namespace atom_mapping {
namespace {

using Eigen::Vector3d;

const Vector3d kShift(200.0, 0.0, 0.0);  // m, of the whole drive at the second playing

class NodeTimeJump : public testing::Test {
 protected:
  void setClock(int i) {
    rosgraph_msgs::Clock clock;
    clock.clock = drive_.header(i, "").stamp;
    clock_.publish(clock);
    EXPECT_TRUE(NodeClient::waitUntil([&] { return ros::Time::now() == clock.clock; }));
  }

  // As rosbag play does: clock, transforms, cloud.
  void play(int i, const Vector3d& shift) {
    const std::size_t before = client_.reports.size();
    setClock(i);
    auto transform = drive_.transform(i);
    transform.transform.translation.x += shift.x();
    client_.publish(transform);
    client_.publish(drive_.cloud(i));
    ASSERT_TRUE(client_.waitForReports(before + 1));
  }

  std::uint8_t askInFrontOfSensor(const Vector3d& shift) {
    QueryOccupancy::Request request;
    request.points.push_back(toPoint(drive_.pose(3) * Vector3d(3.0, 0.0, 0.0) + shift));
    return NodeClient::call<QueryOccupancy>("query_occupancy", request).state.at(0);
  }

  ros::NodeHandle node_;
  ros::Publisher clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 10);
  NodeClient client_;
  const SimulatedDrive drive_ = makeCoarseDrive();
};

TEST_F(NodeTimeJump, ABagPlayedAgainIsMappedFromItsOwnPoses) {
  ASSERT_TRUE(NodeClient::waitUntil([this] { return clock_.getNumSubscribers() >= 2; }));
  ASSERT_TRUE(client_.waitForNode());
  for (int i = 0; i < 5; ++i) play(i, Vector3d::Zero());
  EXPECT_EQ(askInFrontOfSensor(Vector3d::Zero()), int{QueryOccupancy::Response::FREE});
  EXPECT_EQ(askInFrontOfSensor(kShift), int{QueryOccupancy::Response::UNKNOWN});

  for (int i = 0; i < 5; ++i) play(i, kShift);
  EXPECT_EQ(askInFrontOfSensor(kShift), int{QueryOccupancy::Response::FREE});
  EXPECT_EQ(askInFrontOfSensor(Vector3d::Zero()), int{QueryOccupancy::Response::FREE});  // the map is kept
  EXPECT_TRUE(client_.waitForCount("mapped", 10));
  EXPECT_EQ(client_.count("dropped: out of order"), 0);
  EXPECT_EQ(client_.count("dropped: no transform"), 0);
  client_.expectOneWarning("Time began anew");
}

}  // namespace
}  // namespace atom_mapping
