// ~save_map and ~load_map, the map to start from and the one that is left at shutdown, through nodes.
#include <std_srvs/Trigger.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "../test_folder.h"
#include "atom_mapping/MapFile.h"
#include "atom_mapping/QueryOccupancy.h"
#include "atom_mapping/io/map_file.h"
#include "map_file_request.h"
#include "node_client.h"

namespace atom_mapping {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr int kScans = 3;

// A node beside the one under test, named `second`, that starts from a map, whatever its own radius, and leaves one.
class SecondNode {
 public:
  SecondNode(const std::string& load, const std::string& autosave, const std::string& radius = "0.5")
      : process_(fork()) {
    if (process_ != 0) return;
    const std::string program = (fs::read_symlink("/proc/self/exe").parent_path() / "atom_mapping_node").string();
    execl(program.c_str(), program.c_str(), "__name:=second", "cloud_in:=/nothing", ("_radius:=" + radius).c_str(),
          ("_storage/load:=" + load).c_str(), ("_storage/autosave:=" + autosave).c_str(), nullptr);
    _exit(127);
  }

  // Its exit code after a signal, -1 when the signal killed it.
  int end(int signal) {
    kill(process_, signal);
    int status = 0;
    waitpid(process_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t process_;
};

class NodeMapFile : public FolderTest {
 protected:
  void mapScans() {
    ASSERT_TRUE(client_.waitForNode());
    for (int i = 0; i < kScans; ++i) {
      client_.publish(drive_.transform(i));
      client_.publish(drive_.cloud(i));
    }
    ASSERT_TRUE(client_.waitForReports(kScans));
  }

  QueryOccupancy::Response ask(const std::string& service) const {
    QueryOccupancy::Request request;
    const atom_map::Pose pose = drive_.pose(kScans - 1);
    for (int i = 0; i < 2000; ++i) {
      request.points.push_back(toPoint(pose * Vector3d(0.005 * i, 5.0 * std::sin(i), std::cos(3.0 * i))));
    }
    QueryOccupancy::Response response;
    EXPECT_TRUE(ros::service::waitForService(service, ros::Duration(NodeClient::kPatience)));
    EXPECT_TRUE(ros::service::call(service, request, response) && response.success) << response.message;
    return response;
  }

  NodeClient client_;
  SimulatedDrive drive_;
};

TEST_F(NodeMapFile, AMapOutlivesResetAndItsNode) {
  mapScans();
  const auto before = ask("/atom_mapping/query_occupancy");
  const auto saved = NodeClient::call<MapFile>("save_map", at(path("map.h5")));
  ASSERT_TRUE(saved.success) << saved.message;
  EXPECT_EQ(saved.atoms, client_.reports.back().atoms);

  ASSERT_TRUE(NodeClient::call<std_srvs::Trigger>("reset", {}).success);
  EXPECT_NE(ask("/atom_mapping/query_occupancy").state, before.state);
  const auto loaded = NodeClient::call<MapFile>("load_map", at(path("map.h5")));
  ASSERT_TRUE(loaded.success) << loaded.message;
  EXPECT_EQ(loaded.atoms, saved.atoms);
  EXPECT_EQ(ask("/atom_mapping/query_occupancy").probability, before.probability);

  for (const auto& [signal, radius] : {std::make_pair(SIGINT, "0.5"), std::make_pair(SIGTERM, "0.25")}) {
    SecondNode second(path("map.h5"), path("left.h5"), radius);
    EXPECT_EQ(ask("/second/query_occupancy").probability, before.probability);
    ros::service::call("/second/reset", *std::make_unique<std_srvs::Trigger>());
    MapFile again;
    again.request.file = path("map.h5");
    EXPECT_TRUE(ros::service::call("/second/load_map", again));
    EXPECT_EQ(second.end(signal), 0);
    const atom_map::LoadedMap left = atom_map::loadMap(path("left.h5"));
    EXPECT_EQ(left.map.atoms().size(), saved.atoms);
    EXPECT_EQ(left.parameters.radius, 0.5);
    fs::remove(path("left.h5"));
  }
}

TEST_F(NodeMapFile, WhatCannotBeIsRefusedAndTheNodeLivesOn) {
  const auto missing = NodeClient::call<MapFile>("load_map", at(path("none.h5")));
  EXPECT_FALSE(missing.success);
  EXPECT_EQ(missing.message, "cannot load " + path("none.h5") + ": No such file or directory");
  EXPECT_FALSE(NodeClient::call<MapFile>("save_map", at(path("none/map.h5"))).success);
  EXPECT_EQ(SecondNode(path("none.h5"), "").end(0), 1) << "a map to start from that is not there";
}

}  // namespace
}  // namespace atom_mapping
