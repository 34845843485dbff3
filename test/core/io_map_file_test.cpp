// A map that is saved and loaded is the same map.
#include "atom_mapping/base/describe_parameters.h"
#include "atom_mapping/query/occupancy.h"
#include "check_map.h"
#include "map_file_folder.h"
#include "simulated.h"

namespace atom_map {
namespace {

struct Printer {
  std::string& text;

  template <class Number>
  void operator()(const char* name, const Number& value, const Range& /*range*/) const {
    text += name + (" " + std::to_string(value)) + "\n";
  }
  void operator()(const char* name, const std::string& value) const { text += name + (" " + value) + "\n"; }
  void operator()(const char* name, bool value) const { text += name + std::string(value ? " true\n" : " false\n"); }
  void operator()(const char* name, Mode value) const { operator()(name, value == Mode::kOccupancy); }
  void operator()(const char* name, LimitPolicy value) const { operator()(name, value == LimitPolicy::kRefuse); }
};

std::string print(const MappingParameters& parameters) {
  std::string text;
  forEachParameter(parameters, Printer{text});
  return text;
}

TEST_F(MapFile, BringsBackEveryBitOfTheMap) {
  for (const Mode mode : {Mode::kOccupancy, Mode::kSignedDistance}) {
    for (const int count : {0, 1, 2, 33, 1000, 200000}) {
      const MappingParameters parameters = parametersOf(mode, count > 1000 ? 0.1 : 0.25);
      const AtomMap map = drawMap(parameters, count, static_cast<std::uint64_t>(count));
      saveMap(copyOf(parameters, drawMap(parameters, count, static_cast<std::uint64_t>(count))), path("map.h5"));
      const LoadedMap loaded = loadMap(path("map.h5"));
      EXPECT_EQ(bytesOf(loaded.map), bytesOf(map));
      EXPECT_EQ(loaded.map.atoms().size(), map.atoms().size());
      EXPECT_EQ(numbersOf(loaded.map.planes()), numbersOf(map.planes()));
      EXPECT_EQ(loaded.map.origin(), count == 0 ? Eigen::Vector3d(1e5, -1e5, 37) : map.origin());
      EXPECT_EQ(loaded.map.mode(), mode);
      EXPECT_EQ(loaded.map.radius(), map.radius());
      EXPECT_EQ(loaded.scans, 7U);
    }
  }
}

// Where floats round the atoms' distances by more than they are.
TEST_F(MapFile, BringsBackAMapFarFromItsOrigin) {
  for (const double distance : {1e5, 1.2e6, 1e7}) {
    const MappingParameters parameters = parametersOf(Mode::kOccupancy);
    AtomMap map(parameters.mode, parameters.radius);
    map.anchor(Eigen::Vector3d::Zero());
    for (int i = 0; i < 100; ++i) {
      const float value = 1.0F;
      map.atoms().insert(map.toLocal(Eigen::Vector3d(distance, 0.5 * i, 0.0)), &value);
    }
    const std::vector<float> bytes = bytesOf(map);
    saveMap(copyOf(parameters, std::move(map)), path("map.h5"));
    EXPECT_EQ(bytesOf(loadMap(path("map.h5")).map), bytes) << distance;
  }
}

// Or its file would hold values that its own clamp forbids.
TEST_F(MapFile, AMapOfAGreaterClampIsClampedByWhoAdoptsIt) {
  MappingParameters parameters = parametersOf(Mode::kOccupancy);
  saveMap(copyOf(parameters, drawMap(parameters, 1000, 1)), path("theirs.h5"));
  parameters.occupancy.max_log_odds = 1.5;
  saveMap(copyOf(parameters, loadMap(path("theirs.h5")).map), path("ours.h5"));
  const LoadedMap loaded = loadMap(path("ours.h5"));
  EXPECT_GT(loaded.map.atoms().size(), 500U);
  loaded.map.atoms().forEach([](ConstAtomRef atom) { EXPECT_LE(std::abs(atom.value()), 1.5F); });
}

TEST_F(MapFile, BringsBackEveryParameter) {
  MappingParameters parameters = parametersOf(Mode::kSignedDistance, 0.3);
  parameters.map_frame = "odom, \"the other\" \xc3\xa9";
  parameters.seed = 4294967295U;
  parameters.scan.clear_no_returns = true;
  parameters.scan.max_range = 1.0 / 3.0 + 40.0;
  parameters.gaussian_process.neighbors = 5;
  parameters.limits = {1000000, 12.5, LimitPolicy::kForgetFarthest, 60.0};
  saveMap(copyOf(parameters, drawMap(parameters, 10, 1)), path("map.h5"));
  EXPECT_EQ(print(loadMap(path("map.h5")).parameters), print(parameters));
  EXPECT_EQ(loadMap(path("map.h5")).parameters.scan.max_range, parameters.scan.max_range);
}

TEST_F(MapFile, SavedLoadedAndSavedAgainIsTheSameFile) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const MappingParameters parameters = parametersOf(seed % 2 == 0 ? Mode::kOccupancy : Mode::kSignedDistance);
    AtomMap map = drawMap(parameters, 3000, seed);
    const Eigen::Vector3d corner = map.origin() + Eigen::Vector3d(seed, -3.0, -5.0);
    map.clearRegion({corner, corner + Eigen::Vector3d::Constant(9.0)});  // leaves as no insertion makes them
    saveMap(copyOf(parameters, std::move(map)), path("first.h5"));
    LoadedMap loaded = loadMap(path("first.h5"));
    saveMap(copyOf(loaded.parameters, std::move(loaded.map), loaded.scans), path("second.h5"));
    ASSERT_EQ(contents(path("first.h5")), contents(path("second.h5"))) << "seed " << seed;
  }
}

TEST_F(MapFile, ALoadedMapAnswersTheSameToTheBit) {
  const MappingParameters parameters = parametersOf(Mode::kOccupancy);
  const AtomMap map = drawMap(parameters, 30000, 3);
  saveMap(copyOf(parameters, drawMap(parameters, 30000, 3)), path("map.h5"));
  const LoadedMap loaded = loadMap(path("map.h5"));
  Random random(4);
  int known = 0;
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3f point = drawWithin(random, 18.0F);
    const auto expected = interpolate(map, point);
    EXPECT_EQ(interpolate(loaded.map, point), expected);
    known += expected ? 1 : 0;
  }
  EXPECT_GT(known, 300);
}

TEST_F(MapFile, MappingGoesOnAsIfItHadNeverStopped) {
  const Drive drive = makeDrive("cube", 6, 3);
  LimitParameters forgetful;
  forgetful.max_atoms = 500;  // of which each scan forgets some
  forgetful.policy = LimitPolicy::kForgetFarthest;
  for (const auto& [mode, limits] : {std::pair(Mode::kOccupancy, LimitParameters{}),
                                     {Mode::kSignedDistance, LimitParameters{}},
                                     {Mode::kOccupancy, forgetful}}) {
    MappingParameters parameters = parametersOf(mode, 0.1);
    parameters.scan.min_range = 0.1;
    parameters.limits = limits;
    Mapper whole(parameters);
    Mapper first(parameters);
    Mapper second(parameters);
    for (std::size_t i = 0; i < 6; ++i) {
      whole.insertScan(drive.scans[i], drive.poses[i]);
      (i < 3 ? first : second).insertScan(drive.scans[i], drive.poses[i]);
      if (i != 2) continue;
      saveMap(copyMap(first), path("map.h5"));
      LoadedMap loaded = loadMap(path("map.h5"));
      second.replace(std::move(loaded.map), loaded.scans);
    }
    const auto bytes = [](const AtomMap& map) { return bytesOf(map); };
    EXPECT_GT(whole.read(bytes).size(), 1000U);
    EXPECT_EQ(second.read(bytes), whole.read(bytes));
  }
}

// Less where more is known: scans that agree bring log-odds to the clamps.
TEST_F(MapFile, AnAtomOfOccupancyTakesAtMostTwelveBytes) {
  const Drive drive = makeDrive("hall", 3, 10);
  Mapper mapper(parametersOf(Mode::kOccupancy, 0.1));
  for (std::size_t i = 0; i < drive.scans.size(); ++i) mapper.insertScan(drive.scans[i], drive.poses[i]);
  const MapCopy copy = copyMap(mapper);
  saveMap(copy, path("map.h5"));
  const auto bytes = static_cast<double>(std::filesystem::file_size(path("map.h5")));
  EXPECT_GT(copy.size(), 20000U);
  EXPECT_LE(bytes / static_cast<double>(copy.size()), 12.0);
  RecordProperty("bytes_per_atom", std::to_string(bytes / static_cast<double>(copy.size())));
}

}  // namespace
}  // namespace atom_map
