// A file's ending says what is saved; what cannot be saved is reported; and saving holds no scan up for long.
#include <atomic>
#include <filesystem>
#include <thread>

#include "atom_mapping/baseline/export_map.h"
#include "atom_mapping/io/map_file.h"
#include "map_storage_folder.h"

namespace atom_mapping {
namespace {

namespace fs = std::filesystem;
using atom_map::AtomMap;

TEST_F(MapStorageTest, OtherEndingsExportTheAtomsAsTheOfflineToolDoes) {
  for (const auto mode : {atom_map::Mode::kOccupancy, atom_map::Mode::kSignedDistance}) {
    atom_map::MappingParameters parameters = coarse();
    parameters.mode = mode;
    ScanServer server(parameters);
    mapScans(server, 0, 2);
    MapStorage storage(server, {});
    for (const char* ending : {".ply", ".pcd", ".csv", ".bt"}) {
      const auto saved = storage.save(at(path(std::string("a") + ending)));
      ASSERT_TRUE(saved.success) << saved.message;
      EXPECT_EQ(saved.atoms, server.read([](const AtomMap& map) { return map.atoms().size(); }));
      EXPECT_EQ(saved.message,
                "exported " + std::to_string(saved.atoms) + " atoms to " + path(std::string("a") + ending));
      server.read([&](const AtomMap& map) { atom_map::exportMap(map, path(std::string("b") + ending)); });
      EXPECT_EQ(contents(path(std::string("a") + ending)), contents(path(std::string("b") + ending)));
      EXPECT_FALSE(storage.load(at(path(std::string("a") + ending))).success) << "atoms alone are no map";
    }
  }
}

TEST_F(MapStorageTest, AnUnknownEndingIsRefusedWithThoseThereAre) {
  MapStorage storage(server_, {});
  for (const char* name : {"map", "map.obj", "map.h5.bak", ".h5", "map.H5"}) {
    const auto response = storage.save(at(path(name)));
    EXPECT_FALSE(response.success) << name;
    EXPECT_EQ(response.message, "cannot save to " + path(name) +
                                    ": name a file that ends in .h5 for the map, in .ply, .pcd or .csv for its atoms, "
                                    "or in .bt for an OctoMap");
    EXPECT_FALSE(fs::exists(path(name)));
  }
}

TEST_F(MapStorageTest, AFileThatCannotBeWrittenIsReported) {
  MapStorage storage(server_, {});
  const auto response = storage.save(at(path("none/map.h5")));
  EXPECT_FALSE(response.success);
  EXPECT_EQ(response.message, "cannot write " + path("none/map.h5") + ": No such file or directory");
  EXPECT_EQ(storage.save(at("")).message, "file is empty; name one, such as /tmp/map.h5");
}

// Scans at full speed beside saves at full speed.
TEST_F(MapStorageTest, SavingHoldsNoScanUpForLong) {
  MapStorage storage(server_, {});
  std::atomic<bool> stop{false};
  std::atomic<int> saves{0};
  std::thread saving([&] {
    while (!stop) saves += storage.save(at(path("map.h5"))).success ? 1 : 0;
  });
  mapScans(server_, 0, 30);
  while (saves < 2) std::this_thread::yield();
  stop = true;
  saving.join();
  EXPECT_EQ(server_.counts().mapped, 30U);
  EXPECT_GT(atom_map::loadMap(path("map.h5")).map.atoms().size(), 100U);
}

}  // namespace
}  // namespace atom_mapping
