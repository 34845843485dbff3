// OctoMap beside atom_mapping_node: made of the same clouds, asked by the same services.
#include <ros/ros.h>
#include <tf2/buffer_core.h>
#include <tf2_ros/transform_listener.h>

#include "atom_mapping/ros/baseline_queries.h"
#include "atom_mapping/ros/read_parameters.h"
#include "atom_mapping/ros/run_node.h"
#include "atom_mapping/ros/scan_input.h"
#include "atom_mapping/ros/scan_reporter.h"
#include "atom_mapping/ros/serve.h"
#include "atom_mapping/ros/snapshot_publisher.h"
#include "atom_mapping/ros/transform_memory.h"
#include "atom_mapping/ros/voxel_messages.h"

namespace atom_mapping {
namespace {

// The node's parts, in the order in which they depend on one another.
class BaselineNode {
 public:
  explicit BaselineNode(const BaselineParameters& parameters)
      : server_(parameters),
        transforms_(transformMemory(parameters.node.input)),
        queries_(server_, transforms_, parameters.node.services),
        reporter_(node_, private_node_, server_, [this](auto& status) { describeMap(server_, status); }),
        publisher_(server_, parameters.node.publish.period, [this] { return takeSnapshot(server_); }),
        input_(node_, server_, transforms_, parameters.node.input,
               [this](const auto& cloud, const ScanOutcome& outcome) { reporter_.report(cloud, outcome); }) {
    const auto answer = [this](const auto& request) { return queries_.answer(request); };
    services_ = {serve<QueryOccupancy>(private_node_, "query_occupancy", answer, log_),
                 serve<CheckCollision>(private_node_, "check_collision", answer, log_),
                 serve<MapFile>(private_node_, "save_map", answer, log_), serveReset(private_node_, queries_)};
    publisher_.advertise<visualization_msgs::MarkerArray>(private_node_, "occupied_cells_vis_array", toMarkers);
    publisher_.advertise<sensor_msgs::PointCloud2>(private_node_, "octomap_point_cloud_centers", toCenters);
    publisher_.start();
  }

 private:
  ros::NodeHandle node_;
  ros::NodeHandle private_node_{"~"};
  ThrottledLog log_;
  BaselineServer server_;
  tf2::BufferCore transforms_;
  BaselineQueries queries_;
  ScanReporter reporter_;
  SnapshotPublisher<VoxelSnapshot> publisher_;
  ScanInput input_;
  std::vector<ros::ServiceServer> services_;
  tf2_ros::TransformListener listener_{transforms_};  // stops first: it calls what waits for transforms
};

}  // namespace
}  // namespace atom_mapping

int main(int argc, char** argv) {
  ros::init(argc, argv, "octomap_baseline");
  return atom_mapping::runNode<atom_mapping::BaselineNode>(atom_mapping::readBaselineParameters);
}
