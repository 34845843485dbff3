// The program atom_mapping_offline, started as a user would, on bags made here.
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "../test_folder.h"
#include "atom_mapping/baseline/export_octree.h"
#include "atom_mapping/io/export_atoms.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/write_mesh.h"
#include "atom_mapping/ros/simulated_messages.h"
#include "atom_mapping/sim/make_scene.h"
#include "atom_mapping/surface/extract_surface.h"
#include "program_runner.h"

namespace atom_mapping {
namespace {

ros::Time stampOf(int scan) {
  return ros::Time(1500000000) + ros::Duration(0.1 * scan);
}

std_msgs::Header headerOf(int scan, const std::string& frame) {
  std_msgs::Header header;
  header.stamp = stampOf(scan);
  header.frame_id = frame;
  return header;
}

sensor_msgs::PointCloud2 cloudOf(int scan) {
  const auto drive = atom_map::makeTrajectory("cube");
  const auto simulated = atom_map::simulateScan(atom_map::makeScene("cube"), drive, 0.1 * scan, {}, 1);
  return atom_map::toPointCloud2(simulated, headerOf(scan, "velodyne"));
}

tf2_msgs::TFMessage transformOf(int scan, const std::string& fixed_frame) {
  tf2_msgs::TFMessage message;
  const auto pose = atom_map::makeTrajectory("cube").sensorPose(0.1 * scan);
  message.transforms.push_back(atom_map::toTransformStamped(pose, headerOf(scan, fixed_frame), "velodyne"));
  return message;
}

// What a bag of five scans holds.
struct BagContent {
  std::vector<std::string> cloud_topics = {"/velodyne_points"};
  std::string fixed_frame = "map";  // empty: there are no transforms
  double transform_delay = 0.0;     // s after the cloud that a transform is recorded
  int first_transform = 0;          // scan from which on there are some
};

class Offline : public FolderTest {
 protected:
  std::string writeBag(const std::string& name, const BagContent& content) const {
    rosbag::Bag bag(path(name), rosbag::bagmode::Write);
    bag.write("/chatter", stampOf(0), std_msgs::String());
    for (int scan = 0; scan < 5; ++scan) {
      for (const std::string& topic : content.cloud_topics) bag.write(topic, stampOf(scan), cloudOf(scan));
      if (content.fixed_frame.empty() || scan < content.first_transform) continue;
      const ros::Time recorded = stampOf(scan) + ros::Duration(content.transform_delay);
      bag.write("/tf", recorded, transformOf(scan, content.fixed_frame));
    }
    return path(name);
  }

  std::string writeText(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }

  ProgramResult run(const std::string& arguments) const {
    return runProgram("atom_mapping_offline", arguments, folder_);
  }

  void expectFault(const std::string& arguments, const std::string& message) const {
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_TRUE(contains(result.err, "atom_mapping_offline: ")) << result.err;
    EXPECT_TRUE(contains(result.err, message)) << arguments << ": " << result.err;
  }
};

TEST_F(Offline, MapsABagAndTellsWhatCameOfIt) {
  const std::string bag = writeBag("five.bag", {});
  const ProgramResult result = run("--bag " + bag + " --export " + path("a.ply") + " --export " + path("a.csv"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  for (const char* part : {"five.bag, /velodyne_points\n", "scans mapped      5 in ", "scans dropped     0\n",
                           "points            ", "\natoms             ", " an atom\n", "\n  merge "}) {
    EXPECT_TRUE(contains(result.out, part)) << part << "\n" << result.out;
  }
  const std::size_t at = result.out.find("\natoms") + 19;
  const std::string atoms = result.out.substr(at, result.out.find('\n', at) - at);
  EXPECT_GT(std::stoi(atoms), 10);
  EXPECT_TRUE(contains(contents(path("a.ply")), "element vertex " + atoms + "\n"));
  const std::string csv = contents(path("a.csv"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), std::stoi(atoms) + 1);
  EXPECT_TRUE(contains(result.err, "100 %  5 of 5 scans in 0:0")) << result.err;
  EXPECT_FALSE(contains(result.err, "\r")) << "a bar in a log";
}

TEST_F(Offline, SavesAMapThatHoldsWhatItExports) {
  const std::string bag = writeBag("five.bag", {});
  const std::string exports = " --export " + path("a.ply") + " --export " + path("a.bt");
  ASSERT_EQ(run("--bag " + bag + " --save " + path("map.h5") + exports).exit_code, 0);
  const atom_map::LoadedMap loaded = atom_map::loadMap(path("map.h5"));
  EXPECT_EQ(loaded.scans, 5U);
  atom_map::exportAtoms(loaded.map, path("b.ply"));
  EXPECT_EQ(contents(path("a.ply")), contents(path("b.ply")));
  atom_map::exportOctree(loaded.map, path("b.bt"));
  EXPECT_EQ(contents(path("a.bt")), contents(path("b.bt")));
}

TEST_F(Offline, WritesTheSurfaceOfTheMapThatItSaves) {
  const std::string bag = writeBag("five.bag", {});
  for (const std::string mode : {"occupancy", "signed_distance"}) {
    const ProgramResult result = run("--bag " + bag + " --mode " + mode + " --radius 0.1 --save " + path("map.h5") +
                                     " --surface " + path("a.ply") + " --surface-resolution 0.08");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const atom_map::LoadedMap loaded = atom_map::loadMap(path("map.h5"));
    atom_map::SurfaceRequest request;
    request.resolution = 0.08F;
    const auto mesh = atom_map::extractSurface(loaded.map, loaded.parameters, request);
    EXPECT_GT(mesh.triangles.size(), 100U);
    EXPECT_TRUE(contains(result.out, "surface           " + std::to_string(mesh.triangles.size()) + " triangles\n"));
    atom_map::writeMesh(mesh, path("b.ply"));
    EXPECT_TRUE(contents(path("a.ply")) == contents(path("b.ply")));
    EXPECT_TRUE(contains(contents(path("a.ply")), "property float variance\n"));
  }
}

TEST_F(Offline, TheSameBagGivesTheSameBytes) {
  const std::string bag = writeBag("five.bag", {});
  ASSERT_EQ(run("--bag " + bag + " --export " + path("a.ply")).exit_code, 0);
  ASSERT_EQ(run("--bag " + bag + " --export " + path("b.ply")).exit_code, 0);
  EXPECT_EQ(contents(path("a.ply")), contents(path("b.ply")));
}

TEST_F(Offline, ArgumentsOverruleTheConfiguration) {
  const std::string bag = writeBag("five.bag", {});
  const std::string config = writeText("config.yaml", "radius: 0.3\nscan: {max_range: 1.2}\n");
  ProgramResult result = run("--bag " + bag + " --config " + config + " --export " + path("a.ply"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(contents(path("a.ply")), "comment radius 0.3\n"));
  EXPECT_TRUE(contains(result.out, "too far"));
  result = run("--bag " + bag + " --config " + config + " --radius 0.2 --scans 2 --export " + path("a.ply"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(contents(path("a.ply")), "comment radius 0.2\n"));
  EXPECT_TRUE(contains(result.out, "scans mapped      2 in "));
  EXPECT_TRUE(contains(result.err, "2 of 2 scans"));
}

TEST_F(Offline, TransformsRecordedSecondsLaterStillServe) {
  BagContent late;
  late.transform_delay = 5.0;
  const ProgramResult result = run("--bag " + writeBag("late.bag", late));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "scans mapped      5 in ")) << result.out;
}

TEST_F(Offline, ScansWithoutTransformAreDroppedAndCounted) {
  BagContent part;
  part.first_transform = 2;
  const ProgramResult result = run("--bag " + writeBag("part.bag", part));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "scans mapped      3 in ")) << result.out;
  EXPECT_TRUE(contains(result.out, "scans dropped     2, no transform 2\n")) << result.out;
}

// A robot whose clock begins anew, elsewhere.
TEST_F(Offline, MappingGoesOnWhereTheStampsBeginAnew) {
  constexpr int kScans = 30;
  constexpr double kElsewhere = 200.0;  // m
  std::vector<sensor_msgs::PointCloud2> clouds;
  for (int scan = 0; scan < kScans; ++scan) clouds.push_back(cloudOf(scan));
  rosbag::Bag bag(path("twice.bag"), rosbag::bagmode::Write);
  for (int i = 0; i < 2 * kScans; ++i) {
    auto transforms = transformOf(i % kScans, "map");
    if (i >= kScans) transforms.transforms[0].transform.translation.x += kElsewhere;
    bag.write("/tf", stampOf(i), transforms);
    bag.write("/velodyne_points", stampOf(i), clouds[i % kScans]);
  }
  bag.close();
  const ProgramResult result = run("--bag " + path("twice.bag") + " --save " + path("map.h5"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "scans mapped      56 in ")) << result.out;
  EXPECT_TRUE(contains(result.out, "scans dropped     4, out of order 4\n")) << result.out;
  std::size_t here = 0;
  std::size_t elsewhere = 0;
  const atom_map::LoadedMap loaded = atom_map::loadMap(path("map.h5"));
  loaded.map.atoms().forEach([&](const atom_map::ConstAtomRef& atom) {
    const double x = loaded.map.toMap(atom.center()).x();
    here += std::abs(x) < 10.0 ? 1 : 0;
    elsewhere += std::abs(x - kElsewhere) < 10.0 ? 1 : 0;
  });
  EXPECT_GT(here, 10U);
  EXPECT_GT(elsewhere, 10U);
  EXPECT_EQ(here + elsewhere, loaded.map.atoms().size()) << "poses between those of the two runs";
}

TEST_F(Offline, TheTopicOfTheCloudsIsFoundOrAsked) {
  const std::string one = writeBag("one.bag", {{"/points"}});
  const std::string usual = writeBag("usual.bag", {{"/a", "/velodyne_points"}});
  const std::string two = writeBag("two.bag", {{"/a", "/b"}});
  EXPECT_TRUE(contains(run("--bag " + one).out, "one.bag, /points\n"));
  EXPECT_TRUE(contains(run("--bag " + usual).out, "usual.bag, /velodyne_points\n"));
  EXPECT_TRUE(contains(run("--bag " + two + " --topic /b").out, "two.bag, /b\n"));
  expectFault("--bag " + two, "several topics of clouds, choose one by --topic: /a, /b\n");
  expectFault("--bag " + two + " --topic /c", "holds no clouds on /c, but on /a, /b\n");
  expectFault("--bag " + two + " --topic /chatter", "holds no clouds on /chatter, but on /a, /b\n");
  expectFault("--bag " + writeBag("none.bag", {{}, "map"}), "its topics: /chatter (std_msgs/String), /tf (");
}

TEST_F(Offline, ABagWithoutTheTransformsIsRefused) {
  expectFault("--bag " + writeBag("no_tf.bag", {{"/velodyne_points"}, ""}), "holds no tf: record /tf");
  expectFault(
      "--bag " + writeBag("odom.bag", {{"/velodyne_points"}, "odom"}),
      "nothing was mapped (tf knows odom, velodyne; the parameter map_frame names the map's frame): no transform");
}

TEST_F(Offline, AFileThatIsNoWholeBagIsRefused) {
  const std::string whole = contents(writeBag("whole.bag", {}));
  expectFault("--bag " + path("missing.bag"), "cannot open " + path("missing.bag") + ": No such file or directory\n");
  expectFault("--bag " + folder_.string(), " is no bag of ROS 1\n");
  expectFault("--bag " + writeText("empty.bag", ""), " is no bag of ROS 1\n");
  expectFault("--bag " + writeText("text.bag", "hello"), " is no bag of ROS 1\n");
  for (const std::size_t size : {std::size_t{13}, std::size_t{5000}, whole.size() / 2, whole.size() - 1}) {
    const std::string cut = writeText("cut.bag", whole.substr(0, size));
    expectFault("--bag " + cut, "`rosbag reindex " + cut + "`");
  }
}

TEST_F(Offline, ABagWhoseRecordingWasInterruptedIsRefused) {
  rosbag::Bag bag(path("open.bag"), rosbag::bagmode::Write);
  bag.setChunkThreshold(1);
  for (int scan = 0; scan < 5; ++scan) bag.write("/velodyne_points", stampOf(scan), cloudOf(scan));
  expectFault("--bag " + path("open.bag"), "open.bag has no index, its recording was cut short");
  bag.close();
}

TEST_F(Offline, BadArgumentsAreRefused) {
  const std::string bag = "--bag " + writeBag("five.bag", {});
  expectFault("", "--bag is required\n");
  expectFault(bag + " --radius -1", "radius is -1; it must be ");
  expectFault(bag + " --radius nan", "radius is nan; it must be ");
  expectFault(bag + " --radius wide", "--radius");
  expectFault(bag + " --mode tsdf", "mode is 'tsdf'; it must be occupancy or signed_distance\n");
  expectFault(bag + " --scans 0", "--scans");
  expectFault(bag + " --config " + path("none.yaml"), "cannot open --config " + path("none.yaml") + "\n");
  expectFault(bag + " --config " + writeText("bad.yaml", "radius: ["), "bad.yaml: ");
  expectFault(bag + " --config " + writeText("unknown.yaml", "raduis: 1"), "raduis is no parameter");
  expectFault(bag + " --export " + path("map.obj"), "name a file that ends in .ply, .pcd, .csv or .bt\n");
  expectFault(bag + " --surface " + path("mesh.obj"), "name a file that ends in .ply\n");
  expectFault(bag + " --surface " + path("none/mesh.ply"), "none/mesh.ply: No such file or directory\n");
  for (const char* resolution : {"-1", "nan", "inf", "1e-9"}) {
    expectFault(bag + " --surface " + path("mesh.ply") + " --surface-resolution " + resolution, "resolution is ");
  }
  expectFault(bag + " --save " + path("none/map.h5"), "none/map.h5: No such file or directory\n");
  expectFault(bag + " --export " + path("none/map.ply"), "none/map.ply: No such file or directory\n");
  EXPECT_EQ(run("--help").exit_code, 0);
}

}  // namespace
}  // namespace atom_mapping
