// A map that does not fit the node's, and a file that is none, are refused with the remedy, and the node's map stays.
#include <filesystem>
#include <stdexcept>

#include "atom_mapping/io/map_file.h"
#include "atom_mapping/map/map_limit.h"
#include "map_storage_folder.h"

namespace atom_mapping {
namespace {

namespace fs = std::filesystem;
using atom_map::AtomMap;

TEST_F(MapStorageTest, AMapOfAnotherKindIsRefusedWithTheRemedy) {
  MapStorage storage(server_, {});
  mapScans(server_, 0, 1);
  atom_map::MappingParameters other = coarse();
  other.radius = 0.25;
  expectRefused(
      storage, saveOther(other),
      "its radius is 0.25 and this node's is 0.5; load another map, or start the node with radius 0.25, or call "
      "~reset first");
  other = coarse();
  other.mode = atom_map::Mode::kSignedDistance;
  const std::vector<float> before = bitsOf(server_);
  expectRefused(storage, saveOther(other), "its mode is signed_distance and this node's is occupancy; load another");
  EXPECT_EQ(bitsOf(server_), before);
  EXPECT_EQ(server_.parameters().mode, atom_map::Mode::kOccupancy);
  server_.reset();
  EXPECT_TRUE(storage.load(at(path("other.h5"))).success) << "the remedy";
}

TEST_F(MapStorageTest, AMapInAnotherFrameIsRefusedAndASlashIsNone) {
  MapStorage storage(server_, {});
  atom_map::MappingParameters other = coarse();
  other.map_frame = "odom";
  atom_map::saveMap(atom_map::copyMap(atom_map::Mapper(other)), path("odom.h5"));
  expectRefused(storage, path("odom.h5"), "its map_frame is odom and this node's is map; load another");
  other.map_frame = "/map";
  atom_map::saveMap(atom_map::copyMap(atom_map::Mapper(other)), path("slash.h5"));
  EXPECT_TRUE(storage.load(at(path("slash.h5"))).success);
}

TEST_F(MapStorageTest, AMapLargerThanTheLimitIsRefusedWithTheRemedyOrForgotten) {
  mapScans(server_, 0, 3);
  ASSERT_TRUE(MapStorage(server_, {}).save(at(path("map.h5"))).success);
  const std::size_t all = server_.read([](const AtomMap& map) { return map.atoms().size(); });
  for (const bool by_bytes : {false, true}) {
    atom_map::MappingParameters parameters = coarse();
    if (!by_bytes) parameters.limits.max_atoms = static_cast<std::uint32_t>(all / 2);
    if (by_bytes) parameters.limits.max_megabytes = 12e-6 * static_cast<double>(all);
    ScanServer refusing(parameters);
    mapScans(refusing, 0, 1);
    const std::vector<float> before = bitsOf(refusing);
    const auto refused = MapStorage(refusing, {}).load(at(path("map.h5")));
    EXPECT_FALSE(refused.success);
    const std::string atoms = "its " + std::to_string(all) + " atoms (";
    EXPECT_NE(refused.message.find(atoms), std::string::npos) << refused.message;
    EXPECT_NE(refused.message.find("set limits/policy to forget_farthest"), std::string::npos) << refused.message;
    EXPECT_EQ(bitsOf(refusing), before);
    EXPECT_THROW(MapStorage(refusing, {path("map.h5"), "", 60.0}), std::invalid_argument);

    parameters.limits.policy = atom_map::LimitPolicy::kForgetFarthest;
    ScanServer forgetting(parameters);
    const auto loaded = MapStorage(forgetting, {}).load(at(path("map.h5")));
    ASSERT_TRUE(loaded.success) << loaded.message;
    EXPECT_GT(loaded.atoms, all / 4);
    forgetting.read([&](const AtomMap& map) {
      EXPECT_EQ(map.atoms().size(), loaded.atoms);
      EXPECT_TRUE(atom_map::limitOf(parameters.limits).holds(map.atoms()));
    });
  }
}

TEST_F(MapStorageTest, AFileThatIsNotThereOrDamagedIsRefusedAndTheMapStays) {
  MapStorage storage(server_, {});
  mapScans(server_, 0, 1);
  const std::vector<float> before = bitsOf(server_);
  expectRefused(storage, path("none.h5"), "cannot load " + path("none.h5") + ": No such file or directory");
  expectRefused(storage, "", "file is empty; name one");
  ASSERT_TRUE(storage.save(at(path("map.h5"))).success);
  fs::resize_file(path("map.h5"), 5000);
  expectRefused(storage, path("map.h5"), "it is cut short");
  EXPECT_EQ(bitsOf(server_), before);
}

}  // namespace
}  // namespace atom_mapping
