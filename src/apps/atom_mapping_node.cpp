// Maps a lidar's clouds and answers questions about the map: topics, services and parameters as in the README.
#include <ros/ros.h>
#include <tf2/buffer_core.h>
#include <tf2_ros/transform_listener.h>

#include "atom_mapping/ros/map_publisher.h"
#include "atom_mapping/ros/map_queries.h"
#include "atom_mapping/ros/read_parameters.h"
#include "atom_mapping/ros/run_node.h"
#include "atom_mapping/ros/scan_input.h"
#include "atom_mapping/ros/scan_reporter.h"
#include "atom_mapping/ros/scan_server.h"
#include "atom_mapping/ros/serve.h"
#include "atom_mapping/ros/surface_service.h"

namespace atom_mapping {
namespace {

// The node's parts, in the order in which they depend on one another.
class MappingNode {
 public:
  explicit MappingNode(const Parameters& parameters)
      : server_(parameters.mapping),
        queries_(server_, transforms_, parameters.node.services),
        surface_(private_node_, server_, parameters.node.services,
                 [](const std::string& line) { ROS_INFO_STREAM(line); }),
        reporter_(node_, private_node_, server_, [this](auto& status) { describeMap(server_, status); }),
        publisher_(private_node_, server_, parameters.node.publish),
        input_(node_, server_, transforms_, parameters.node.input,
               [this](const auto& cloud, const ScanOutcome& outcome) { reporter_.report(cloud, outcome); }) {
    serve<QueryOccupancy>("query_occupancy", queries_);
    serve<QuerySignedDistance>("query_signed_distance", queries_);
    serve<ExtractSurface>("extract_surface", surface_);
    serve<CheckCollision>("check_collision", queries_);
    serve<CastRay>("cast_ray", queries_);
    serve<ClearRegion>("clear_region", queries_);
    services_.push_back(serveReset(private_node_, queries_));
  }

 private:
  template <class Service, class Answerer>
  void serve(const std::string& name, Answerer& answerer) {
    const auto answer = [&answerer](const auto& request) { return answerer.answer(request); };
    services_.push_back(atom_mapping::serve<Service>(private_node_, name, answer, log_));
  }

  ros::NodeHandle node_;
  ros::NodeHandle private_node_{"~"};
  ThrottledLog log_;
  ScanServer server_;
  tf2::BufferCore transforms_;
  MapQueries queries_;
  SurfaceService surface_;
  ScanReporter reporter_;
  MapPublisher publisher_;
  ScanInput input_;
  std::vector<ros::ServiceServer> services_;
  tf2_ros::TransformListener listener_{transforms_};  // stops first: it calls what waits for transforms
};

}  // namespace
}  // namespace atom_mapping

int main(int argc, char** argv) {
  ros::init(argc, argv, "atom_mapping");
  return atom_mapping::runNode<atom_mapping::MappingNode>(atom_mapping::readParameters);
}
