// Maps a lidar's clouds and answers questions about the map: topics, services and parameters as in the README.
#include <ros/ros.h>
#include <tf2/buffer_core.h>
#include <tf2_ros/transform_listener.h>

#include "atom_mapping/ros/map_publisher.h"
#include "atom_mapping/ros/map_queries.h"
#include "atom_mapping/ros/map_storage.h"
#include "atom_mapping/ros/path_service.h"
#include "atom_mapping/ros/read_parameters.h"
#include "atom_mapping/ros/run_node.h"
#include "atom_mapping/ros/scan_input.h"
#include "atom_mapping/ros/scan_reporter.h"
#include "atom_mapping/ros/scan_server.h"
#include "atom_mapping/ros/serve.h"
#include "atom_mapping/ros/surface_service.h"
#include "atom_mapping/ros/transform_memory.h"

namespace atom_mapping {
namespace {

// The node's parts, in the order in which they depend on one another.
class MappingNode {
 public:
  explicit MappingNode(const Parameters& parameters)
      : server_(parameters.mapping),
        storage_(server_, parameters.node.storage),
        transforms_(transformMemory(parameters.node.input)),
        queries_(server_, transforms_, parameters.node.services),
        surface_(private_node_, server_, parameters.node.services,
                 [](const std::string& line) { ROS_INFO_STREAM(line); }),
        paths_(server_, transforms_),
        path_publisher_(private_node_.advertise<nav_msgs::Path>("path", 1, true)),
        reporter_(node_, private_node_, server_, [this](auto& status) { describeMap(server_, status); }),
        publisher_(private_node_, server_, parameters.node.publish),
        input_(node_, server_, transforms_, parameters.node.input,
               [this](const auto& cloud, const ScanOutcome& outcome) { reporter_.report(cloud, outcome); }) {
    serve<QueryOccupancy>("query_occupancy");
    serve<QuerySignedDistance>("query_signed_distance");
    serve<CheckCollision>("check_collision");
    serve<CastRay>("cast_ray");
    serve<ClearRegion>("clear_region");
    serve<ExtractSurface>("extract_surface", [this](const auto& request) { return surface_.answer(request); });
    serve<MapFile>("save_map", [this](const auto& request) { return storage_.save(request); });
    serve<MapFile>("load_map", [this](const auto& request) { return storage_.load(request); });
    serve<PlanPath>("plan_path", [this](const auto& request) { return show(paths_.answer(request)); });
    services_.push_back(serveReset(private_node_, queries_));
    goals_ = node_.subscribe<geometry_msgs::PoseStamped>("goal", 1, [this](const auto& goal) {
      const PlanPath::Response planned = show(paths_.answerGoal(*goal));
      if (!planned.success) log_.warn("goal", "Planned no path to the goal: " + planned.message);
    });
  }

 private:
  template <class Service>
  void serve(const std::string& name) {
    serve<Service>(name, [this](const auto& request) { return queries_.answer(request); });
  }

  template <class Service, class Answer>
  void serve(const std::string& name, Answer answer) {
    services_.push_back(atom_mapping::serve<Service>(private_node_, name, answer, log_));
  }

  PlanPath::Response show(PlanPath::Response planned) {
    if (planned.success) path_publisher_.publish(planned.path);
    return planned;
  }

  ros::NodeHandle node_;
  ros::NodeHandle private_node_{"~"};
  ThrottledLog log_;
  ScanServer server_;
  MapStorage storage_;  // saves once what may change the map has stopped
  tf2::BufferCore transforms_;
  MapQueries queries_;
  SurfaceService surface_;
  PathService paths_;
  ros::Publisher path_publisher_;
  ScanReporter reporter_;
  MapPublisher publisher_;
  ScanInput input_;
  std::vector<ros::ServiceServer> services_;
  ros::Subscriber goals_;
  tf2_ros::TransformListener listener_{transforms_};  // stops first: it calls what waits for transforms
};

}  // namespace
}  // namespace atom_mapping

int main(int argc, char** argv) {
  ros::init(argc, argv, "atom_mapping");
  return atom_mapping::runNode<atom_mapping::MappingNode>(atom_mapping::readParameters);
}
