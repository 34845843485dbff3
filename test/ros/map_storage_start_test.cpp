// The map to start from gives the node its mode and radius or stops the start, and autosave leaves one for the next start.
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "atom_mapping/io/map_file.h"
#include "map_storage_folder.h"

namespace atom_mapping {
namespace {

namespace fs = std::filesystem;
using atom_map::AtomMap;

TEST_F(MapStorageTest, AMapToStartFromGivesTheNodeItsModeAndRadius) {
  atom_map::MappingParameters other = coarse();
  other.mode = atom_map::Mode::kSignedDistance;
  other.radius = 0.4;  // which no float holds
  const StorageParameters parameters{saveOther(other), path("left.h5"), 1e6};
  {
    const MapStorage storage(server_, parameters);
    EXPECT_EQ(server_.parameters().mode, atom_map::Mode::kSignedDistance);
    EXPECT_EQ(server_.parameters().radius, 0.4);
    server_.clearRegion({Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  }
  EXPECT_EQ(contents(path("left.h5")), contents(path("other.h5")));
}

TEST_F(MapStorageTest, AMapToStartFromThatCannotBeLoadedStopsTheStart) {
  const auto messageOf = [&](const StorageParameters& parameters) -> std::string {
    try {
      MapStorage(server_, parameters);
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  EXPECT_EQ(messageOf({path("none.h5"), "", 60.0}),
            "storage: cannot load " + path("none.h5") + ": No such file or directory");
  EXPECT_EQ(messageOf({"", path("none/map.h5"), 60.0}),
            "storage: cannot write " + path("none/map.h5") + ": No such file or directory");
  EXPECT_EQ(messageOf({"", path("map.ply"), 60.0}),
            "storage: autosave is " + path("map.ply") + "; name a file that ends in .h5");
  EXPECT_EQ(messageOf({path("map.h5"), path("map.h5"), 60.0}), "") << "the first start of a map that is to last";
}

TEST_F(MapStorageTest, AMapOfAnotherRunIsNotReplacedByAutosave) {
  const std::string old = saveOther(coarse());
  fs::copy_file(old, path("more.h5"));
  const std::string bytes = contents(old);
  for (const std::string& load : {std::string(), path("more.h5"), path("none.h5")}) {
    try {
      const MapStorage storage(server_, {load, old, 1e6});
      mapScans(server_, 0, 1);
      ADD_FAILURE() << "started from '" << load << "'";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), "storage: autosave is " + old +
                                  ", which is there already and is not the map to start from; set storage/load to it "
                                  "to go on with it, or move it away");
    }
    EXPECT_EQ(contents(old), bytes);
  }
  fs::create_symlink(old, path("link.h5"));
  EXPECT_NO_THROW(MapStorage(server_, {path("link.h5"), old, 1e6})) << "the same file by another name";
}

TEST_F(MapStorageTest, ARelativeNameIsOneOfTheWorkingDirectory) {
  const std::string name = fs::relative(path("map.h5")).string();
  { const MapStorage storage(server_, {name, path("map.h5"), 1e6}); }
  mapScans(server_, 0, 1);
  ASSERT_TRUE(MapStorage(server_, {}).save(at(name)).success);
  EXPECT_NO_THROW(MapStorage(server_, {name, path("map.h5"), 1e6}));
}

TEST_F(MapStorageTest, TheNextStartGoesOnWhereTheLastEnded) {
  const StorageParameters parameters{path("map.h5"), path("map.h5"), 1e6};
  {
    const MapStorage storage(server_, parameters);
    mapScans(server_, 0, 2);
    EXPECT_FALSE(fs::exists(path("map.h5")));
  }
  const std::string bytes = contents(path("map.h5"));
  ScanServer next(coarse());
  { const MapStorage storage(next, parameters); }
  EXPECT_EQ(bitsOf(next), bitsOf(server_));
  EXPECT_EQ(contents(path("map.h5")), bytes) << "nothing changed, nothing to save";
}

TEST_F(MapStorageTest, AutosaveFollowsTheMap) {
  const MapStorage storage(server_, {"", path("map.h5"), 0.1});
  for (int i = 0; i < 3; ++i) {
    mapScans(server_, i, i + 1);
    const auto scans = server_.mapper().readBetweenScans([](const AtomMap&, std::uint64_t count) { return count; });
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!fs::exists(path("map.h5")) || atom_map::loadMap(path("map.h5")).scans != scans) {
      ASSERT_LT(std::chrono::steady_clock::now(), deadline);
      std::this_thread::yield();
    }
  }
}

TEST_F(MapStorageTest, AnAutosaveThatFailsIsTriedAgain) {
  fs::create_directories(path("disk"));
  const MapStorage storage(server_, {"", path("disk/map.h5"), 0.1});
  fs::rename(path("disk"), path("away"));
  mapScans(server_, 0, 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  fs::rename(path("away"), path("disk"));
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!fs::exists(path("disk/map.h5"))) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline);
    std::this_thread::yield();
  }
  EXPECT_GT(atom_map::loadMap(path("disk/map.h5")).map.atoms().size(), 0U);
}

}  // namespace
}  // namespace atom_mapping
