#include <std_srvs/Trigger.h>

#include "../test_folder.h"
#include "atom_mapping/MapFile.h"
#include "atom_mapping/io/map_file.h"
#include "map_file_request.h"
#include "node_client.h"

namespace atom_mapping {
namespace {

using diagnostic_msgs::DiagnosticStatus;

constexpr std::size_t kScans = 4;
constexpr std::uint64_t kMost = 500;  // atoms

class NodeLimits : public FolderTest {
 protected:
  static DiagnosticStatus mapStatus() { return client->statuses["atom_mapping: map"]; }

  static void SetUpTestSuite() {
    client = new NodeClient;
    ASSERT_TRUE(client->waitForNode());
    const SimulatedDrive drive = makeCoarseDrive();
    for (std::size_t i = 0; i < kScans; ++i) {
      client->publish(drive.transform(static_cast<int>(i)));
      client->publish(drive.cloud(static_cast<int>(i)));
    }
    ASSERT_TRUE(client->waitForReports(kScans));
  }

  static void TearDownTestSuite() { delete client; }

  static inline NodeClient* client = nullptr;
};

TEST_F(NodeLimits, TheReportCountsWhatWasRefused) {
  for (const ScanReport& report : client->reports) EXPECT_LE(report.atoms, kMost);
  EXPECT_EQ(client->reports.back().atoms, kMost);
  EXPECT_GT(client->reports.back().atoms_refused, 100U);
  EXPECT_GT(client->reports.back().atom_updates, 100U) << "the atoms that are there should follow the world";
}

TEST_F(NodeLimits, TheLogSaysWhatToDoAndDoesNotFlood) {
  client->expectOneWarning("set limits/policy to forget_farthest");
}

TEST_F(NodeLimits, DiagnosticsWarn) {
  EXPECT_TRUE(NodeClient::waitUntil([] { return mapStatus().level == DiagnosticStatus::WARN; }));
  EXPECT_NE(mapStatus().message.find("full at 500 atoms"), std::string::npos) << mapStatus().message;
  std::uint64_t refused = 0;
  for (const ScanReport& report : client->reports) refused += report.atoms_refused;
  EXPECT_TRUE(client->waitForCount("atoms refused", static_cast<int>(refused)));
}

TEST_F(NodeLimits, AMapThatIsTooLargeIsRefused) {
  atom_map::MappingParameters parameters;
  parameters.radius = 0.5;
  atom_map::Mapper mapper(parameters);
  const SimulatedDrive drive;
  mapper.insertScan(atom_map::toLidarScan(drive.scan(0)), drive.pose(0));
  atom_map::saveMap(atom_map::copyMap(mapper), path("large.h5"));
  const auto response = NodeClient::call<MapFile>("load_map", at(path("large.h5")));
  EXPECT_FALSE(response.success);
  EXPECT_NE(response.message.find("limits/max_atoms 500"), std::string::npos) << response.message;
}

TEST_F(NodeLimits, ResetMakesRoomAndTheWarningEnds) {
  EXPECT_TRUE(NodeClient::call<std_srvs::Trigger>("reset", {}).success);
  EXPECT_TRUE(NodeClient::waitUntil([] { return mapStatus().level == DiagnosticStatus::OK; }));
}

}  // namespace
}  // namespace atom_mapping
