// The program compare_maps, started as a user would, on a short simulated drive.
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <unistd.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "program_runner.h"

namespace atom_mapping {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kScans = 5;

class CompareMaps : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    fs::create_directories(folder);
    const std::string arguments = "--scene hall --scans " + std::to_string(kScans) + " --out " + path("hall.bag");
    ASSERT_EQ(runProgram("simulate_bag", arguments, folder).exit_code, 0);
  }
  static void TearDownTestSuite() { fs::remove_all(folder); }

  static std::string path(const std::string& name) { return (folder / name).string(); }

  static json compare(const std::string& arguments) {
    const auto result = runProgram(
        "compare_maps", "--bag " + path("hall.bag") + " --json " + path("figures.json") + " " + arguments, folder);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::parse(contents(path("figures.json")));
  }

  static void expectFault(const std::string& arguments, const std::string& message) {
    const auto result = runProgram("compare_maps", arguments, folder);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_TRUE(contains(result.err, "compare_maps: ") && contains(result.err, message)) << result.err;
  }

  static inline const fs::path folder = fs::path(testing::TempDir()) / ("compare_maps_" + std::to_string(getpid()));
};

void expectSane(const json& map) {
  SCOPED_TRACE(map.dump());
  const double mean = map.at("ms_per_scan").at("mean");
  EXPECT_GT(mean, 0.01);
  EXPECT_LE(map.at("ms_per_scan").at("median"), map.at("ms_per_scan").at("p95"));
  EXPECT_LE(map.at("cpu_ms_per_scan"), mean + 2.0) << "more than one thread";
  double stages = 0.0;
  for (const auto& stage : map.at("stages")) stages += stage.get<double>();
  EXPECT_GT(stages, 0.5 * mean);
  EXPECT_LE(stages, mean);

  const double units = map.at("units");
  EXPECT_GT(units, 500.0);
  const double bytes_per_unit = map.at("bytes").get<double>() / units;
  EXPECT_GT(bytes_per_unit, 16.0);
  EXPECT_LT(bytes_per_unit, 120.0);

  EXPECT_NEAR(map.at("free").get<double>() + map.at("false_occupied").get<double>() + map.at("unknown").get<double>(),
              1.0, 1e-9);
  EXPECT_GT(map.at("free"), 0.3);
  EXPECT_GT(map.at("surface"), 0.5);
}

TEST_F(CompareMaps, WritesAllFiguresOfTheThreeMaps) {
  const json figures = compare("--radius 0.5 --max-range 20");
  EXPECT_EQ(figures.at("bag"), path("hall.bag"));
  EXPECT_EQ(figures.at("radius"), 0.5);
  EXPECT_NEAR(figures.at("voxel").get<double>(), 0.5 * std::cbrt(4.0 * M_PI / 3.0), 1e-9);
  EXPECT_EQ(figures.at("max_range"), 20.0);
  EXPECT_EQ(figures.at("scans"), kScans);
  ASSERT_EQ(figures.at("maps").size(), 3U);
  EXPECT_EQ(figures.at("maps")[0].at("name"), "atom_occupancy");
  EXPECT_EQ(figures.at("maps")[1].at("name"), "atom_signed_distance");
  EXPECT_EQ(figures.at("maps")[2].at("name"), "octomap");
  for (const json& map : figures.at("maps")) expectSane(map);
}

TEST_F(CompareMaps, SeveralRadiiGiveAnArray) {
  const json figures = compare("--radius 0.5 1.0 --scans 2 --voxel 0.7");
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].at("radius"), 0.5);
  EXPECT_EQ(figures[1].at("radius"), 1.0);
  for (const json& contest : figures) {
    EXPECT_EQ(contest.at("scans"), 2);
    EXPECT_EQ(contest.at("voxel"), 0.7);
  }
  EXPECT_GT(figures[0].at("maps")[0].at("units"), figures[1].at("maps")[0].at("units"));
}

// What does not depend on the clock: a map is the same whichever maps grow beside it.
TEST_F(CompareMaps, MapsDoNotInfluenceOneAnother) {
  const json alone = compare("--radius 1.0");
  const json together = compare("--radius 0.5 1.0")[1];
  for (std::size_t i = 0; i < 3; ++i) {
    for (const char* key : {"units", "free", "false_occupied", "unknown", "surface"}) {
      EXPECT_EQ(alone.at("maps")[i].at(key), together.at("maps")[i].at(key)) << key;
    }
  }
}

TEST_F(CompareMaps, WithoutTheFilterEveryMapGetsAllReturns) {
  const json thinned = compare("--radius 0.5");
  const json whole = compare("--radius 0.5 --no-filter");
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NE(whole.at("maps")[i].at("units"), thinned.at("maps")[i].at("units")) << i;
  EXPECT_GT(whole.at("maps")[2].at("units"), thinned.at("maps")[2].at("units"));
}

TEST_F(CompareMaps, APrunedOctomapIsSmallerAndAnswersAlike) {
  const json figures = compare("--radius 0.25 --pruned");
  ASSERT_EQ(figures.at("maps").size(), 4U);
  const json& plain = figures.at("maps")[2];
  const json& pruned = figures.at("maps")[3];
  EXPECT_EQ(pruned.at("name"), "octomap_pruned");
  EXPECT_LT(pruned.at("bytes"), plain.at("bytes"));
  EXPECT_LT(pruned.at("units"), plain.at("units"));
  for (const char* key : {"free", "false_occupied", "unknown", "surface"}) EXPECT_EQ(pruned.at(key), plain.at(key));
}

// Thinning is all that the two differ in.
TEST_F(CompareMaps, AnOctomapOfEveryReturnIsThatWithoutTheFilter) {
  const json figures = compare("--radius 0.5 --every-return");
  ASSERT_EQ(figures.at("maps").size(), 4U);
  const json& every = figures.at("maps")[3];
  const json whole = compare("--radius 0.5 --no-filter").at("maps")[2];
  EXPECT_EQ(every.at("name"), "octomap_every_return");
  for (const char* key : {"units", "free", "false_occupied", "unknown", "surface"})
    EXPECT_EQ(every.at(key), whole.at(key));
  EXPECT_GT(every.at("units"), figures.at("maps")[2].at("units"));
}

template <class Keep>
void copyBag(const std::string& from, const std::string& to, Keep keep) {
  const rosbag::Bag whole(from, rosbag::bagmode::Read);
  rosbag::Bag part(to, rosbag::bagmode::Write);
  rosbag::View all(whole);
  for (const rosbag::MessageInstance& message : all) {
    if (keep(message)) part.write(message.getTopic(), message.getTime(), message);
  }
}

TEST_F(CompareMaps, TellsHowManyCloudsWereDroppedAndWhy) {
  EXPECT_FALSE(contains(runProgram("compare_maps", "--bag " + path("hall.bag"), folder).out, "dropped"));
  const ros::Time second_cloud = ros::Time(1500000000) + ros::Duration(0.1);
  copyBag(path("hall.bag"), path("late.bag"),
          [&](const auto& message) { return message.getTopic() != "/tf" || message.getTime() > second_cloud; });
  const auto result = runProgram("compare_maps", "--bag " + path("late.bag"), folder);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(contains(result.out, "2 clouds dropped, the last: no transform from velodyne to map: ")) << result.out;
  copyBag(path("hall.bag"), path("no_tf.bag"),
          [](const auto& message) { return message.getTopic() == "/velodyne_points"; });
  expectFault("--bag " + path("no_tf.bag"), "holds no tf: record /tf");
}

TEST_F(CompareMaps, SaysWhatIsWrong) {
  expectFault("", "--bag is required");
  expectFault("--bag " + path("none.bag"), "cannot open " + path("none.bag"));
  expectFault("--bag " + path("hall.bag") + " --radius -1", "radius is -1");
  expectFault("--bag " + path("hall.bag") + " --max-range -1", "scan/max_range is -1");
  expectFault("--bag " + path("hall.bag") + " --voxel 0", "--voxel");
  expectFault("--bag " + path("hall.bag") + " --scans 1 --json " + path("none/figures.json"),
              "cannot write " + path("none/figures.json"));
  std::ofstream(path("other.yaml")) << "map_frame: nowhere";
  expectFault("--bag " + path("hall.bag") + " --config " + path("other.yaml"), "nowhere");
}

}  // namespace
}  // namespace atom_mapping
