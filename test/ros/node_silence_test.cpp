// What the node tells while no cloud comes.
#include "node_client.h"

namespace atom_mapping {
namespace {

using diagnostic_msgs::DiagnosticStatus;

TEST(NodeSilence, DiagnosticsAndTheLogSayWhereThereAreClouds) {
  NodeClient client;  // advertises /velodyne_points
  const auto status = [&] { return client.statuses["atom_mapping: scans"]; };
  EXPECT_TRUE(NodeClient::waitUntil([&] { return status().level == DiagnosticStatus::WARN; }));
  EXPECT_NE(status().message.find("there are clouds on /velodyne_points"), std::string::npos) << status().message;
  client.expectOneWarning("no cloud on /pionts yet, which nobody publishes");
}

}  // namespace
}  // namespace atom_mapping
