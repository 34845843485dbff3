#include "atom_mapping/ros/map_messages.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <set>

#include "atom_mapping/ros/atom_colors.h"
#include "atom_mapping/ros/cloud_conversion.h"
#include "simulated_input.h"

namespace atom_mapping {
namespace {

using visualization_msgs::Marker;

// Ten occupied atoms one above another, and five free ones beside them.
MapSnapshot makeMap() {
  MapSnapshot map{};
  map.frame = "map";
  map.stamp = ros::Time(7.0);
  map.radius = 0.5F;
  map.origin = Eigen::Vector3d(4e6, 5e6, 100.0);
  for (int i = 0; i < 10; ++i) map.atoms.push_back({Eigen::Vector3f(0, 0, i), {1.0F + i, 0.0F}});
  for (int i = 0; i < 5; ++i) map.atoms.push_back({Eigen::Vector3f(2, 0, i), {-1.0F, 0.0F}});
  return map;
}

TEST(MapMessages, SpheresShowTheOccupiedAtoms) {
  const MapSnapshot map = makeMap();
  const Marker marker = toOccupiedMarker(map, PublishParameters());
  EXPECT_EQ(marker.header.frame_id, "map");
  EXPECT_EQ(marker.header.stamp, ros::Time(7.0));
  EXPECT_EQ(marker.type, int{Marker::SPHERE_LIST});
  EXPECT_EQ(marker.action, int{Marker::ADD});
  EXPECT_EQ(marker.pose.orientation.w, 1.0);
  for (const double scale : {marker.scale.x, marker.scale.y, marker.scale.z}) EXPECT_EQ(scale, 1.0);
  ASSERT_EQ(marker.points.size(), 10U);
  ASSERT_EQ(marker.colors.size(), 10U);
  EXPECT_EQ(marker.points[3].x, 4e6);
  EXPECT_EQ(marker.points[3].z, 103.0);
  for (const auto& color : marker.colors) EXPECT_EQ(color.a, 1.0F);
}

TEST(MapMessages, GlassShowsTheFreeOnes) {
  const Marker marker = toFreeMarker(makeMap(), PublishParameters());
  EXPECT_EQ(marker.points.size(), 5U);
  EXPECT_LT(marker.colors[0].a, 0.5F);
  EXPECT_NE(marker.ns, toOccupiedMarker(makeMap(), PublishParameters()).ns);
}

TEST(MapMessages, HeightsAndOccupancyGiveColors) {
  for (const AtomColor color : {AtomColor::kHeight, AtomColor::kOccupancy}) {
    PublishParameters parameters;
    parameters.color = color;
    const Marker marker = toOccupiedMarker(makeMap(), parameters);
    std::set<float> reds;
    for (const auto& c : marker.colors) reds.insert(c.r);
    EXPECT_GT(reds.size(), 5U);
  }
  const auto low = colorOf(-100.0F);
  const auto high = colorOf(100.0F);
  EXPECT_GT(low.b, low.r);
  EXPECT_GT(high.r, high.b);
}

// As where a map of another mode than the node was started with was loaded.
TEST(MapMessages, AColorThatTheMapsModeDoesNotKnowIsThatOfTheHeight) {
  PublishParameters distance;
  distance.color = AtomColor::kDistance;
  const auto redsOf = [](const Marker& marker) {
    std::vector<float> reds;
    for (const auto& c : marker.colors) reds.push_back(c.r);
    return reds;
  };
  EXPECT_EQ(redsOf(toOccupiedMarker(makeMap(), distance)), redsOf(toOccupiedMarker(makeMap(), PublishParameters())));
}

TEST(MapMessages, NoAtomsDeleteTheMarker) {
  MapSnapshot map = makeMap();
  map.atoms.clear();
  EXPECT_EQ(toOccupiedMarker(map, PublishParameters()).action, int{Marker::DELETE});
  EXPECT_EQ(toAtomCloud(map).width, 0U);
}

TEST(MapMessages, TooManyAtomsAreThinnedEvenly) {
  PublishParameters parameters;
  parameters.max_markers = 5;
  const Marker marker = toOccupiedMarker(makeMap(), parameters);
  ASSERT_EQ(marker.points.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(marker.points[i].z, 100.0 + 2.0 * static_cast<double>(i));
}

TEST(MapMessages, TheCloudHoldsEveryAtom) {
  const MapSnapshot map = makeMap();
  const auto cloud = toAtomCloud(map);
  ASSERT_EQ(cloud.fields.size(), 4U);
  EXPECT_EQ(cloud.fields[3].name, "log_odds");
  const auto points = toLidarScan(cloud).points;
  ASSERT_EQ(points.size(), 15U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i], (map.atoms[i].center.cast<double>() + map.origin).cast<float>());
    float log_odds = 0.0F;
    std::memcpy(&log_odds, &cloud.data[i * cloud.point_step + cloud.fields[3].offset], 4);
    EXPECT_EQ(log_odds, map.atoms[i].values[0]);
  }
}

TEST(MapMessages, SignedDistancesShowWhatIsNearASurface) {
  MapSnapshot map = makeMap();
  map.mode = atom_map::Mode::kSignedDistance;
  map.atoms.clear();
  for (const float distance : {-0.4F, -0.2F, 0.0F, 0.2F, 0.4F}) {
    map.atoms.push_back({Eigen::Vector3f(distance, 0, 0), {distance, 0.01F}});
  }
  PublishParameters parameters;
  parameters.color = AtomColor::kDistance;
  const Marker marker = toOccupiedMarker(map, parameters);
  ASSERT_EQ(marker.points.size(), 3U);
  EXPECT_GT(marker.colors[0].r, marker.colors[2].r);
  const auto cloud = toAtomCloud(map);
  ASSERT_EQ(cloud.fields.size(), 5U);
  EXPECT_EQ(cloud.fields[3].name, "signed_distance");
  EXPECT_EQ(cloud.fields[4].name, "variance");
  float variance = 0.0F;
  std::memcpy(&variance, &cloud.data[cloud.fields[4].offset], 4);
  EXPECT_EQ(variance, 0.01F);
}

TEST(MapSnapshot, CopiesTheMap) {
  const SimulatedDrive drive = makeCoarseDrive();
  tf2::BufferCore transforms;
  transforms.setTransform(drive.transform(0), "test");
  for (const auto mode : {atom_map::Mode::kOccupancy, atom_map::Mode::kSignedDistance}) {
    atom_map::MappingParameters parameters;
    parameters.mode = mode;
    ScanServer server(parameters);
    EXPECT_TRUE(takeSnapshot(server).atoms.empty());
    const auto outcome = server.insert(drive.cloud(0), transforms);
    const MapSnapshot map = takeSnapshot(server);
    EXPECT_EQ(map.atoms.size(), outcome.report.atoms);
    EXPECT_GT(map.atoms.size(), 100U);
    EXPECT_EQ(map.stamp, drive.header(0, "").stamp);
    EXPECT_EQ(map.revision, 1U);
    EXPECT_EQ(map.mode, mode);
    EXPECT_EQ(map.radius, 0.25F);
  }
}

}  // namespace
}  // namespace atom_mapping
