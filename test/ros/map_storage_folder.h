// What the tests of the map's storage share: a server that maps scans of the hall, and a folder of their own for files.
#pragma once

#include <gtest/gtest.h>
#include <tf2/buffer_core.h>

#include <string>
#include <vector>

#include "../test_folder.h"
#include "atom_mapping/MapFile.h"
#include "atom_mapping/map/map_copy.h"
#include "atom_mapping/ros/map_storage.h"
#include "atom_mapping/ros/scan_server.h"
#include "map_file_request.h"
#include "simulated_input.h"

namespace atom_mapping {

// Every bit of a server's map, in its order.
inline std::vector<float> bitsOf(const ScanServer& server) {
  const atom_map::MapCopy copy = atom_map::copyMap(server.mapper());
  std::vector<float> bits;
  for (const std::vector<float>& column : copy.columns) bits.insert(bits.end(), column.begin(), column.end());
  for (const double x : copy.origin) bits.push_back(static_cast<float>(x));
  return bits;
}

inline atom_map::MappingParameters coarse() {
  atom_map::MappingParameters parameters;
  parameters.radius = 0.5;
  parameters.scan.horizontal_resolution = 2.0;
  return parameters;
}

class MapStorageTest : public FolderTest {
 protected:
  void mapScans(ScanServer& server, int begin, int end) {
    for (int i = begin; i < end; ++i) {
      transforms_.setTransform(drive_.transform(i), "test");
      ASSERT_FALSE(server.insert(drive_.cloud(i), transforms_).drop);
    }
  }

  void expectRefused(MapStorage& storage, const std::string& file, const std::string& message) {
    const std::uint64_t revision = server_.revision();
    const auto response = storage.load(at(file));
    EXPECT_FALSE(response.success);
    EXPECT_NE(response.message.find(message), std::string::npos) << response.message;
    EXPECT_EQ(response.atoms, 0U);
    EXPECT_EQ(server_.revision(), revision);
  }

  std::string saveOther(const atom_map::MappingParameters& parameters) {
    ScanServer other(parameters);
    mapScans(other, 0, 1);
    EXPECT_TRUE(MapStorage(other, {}).save(at(path("other.h5"))).success);
    return path("other.h5");
  }

  SimulatedDrive drive_ = makeCoarseDrive();
  tf2::BufferCore transforms_;
  ScanServer server_{coarse()};
};

}  // namespace atom_mapping
