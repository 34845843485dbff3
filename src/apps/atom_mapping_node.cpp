// Maps a lidar's clouds and answers questions about the map: topics, services and parameters as in the README.
#include <ros/ros.h>
#include <tf2/buffer_core.h>
#include <tf2_ros/transform_listener.h>

#include <csignal>
#include <stdexcept>

#include "atom_mapping/ros/map_publisher.h"
#include "atom_mapping/ros/map_queries.h"
#include "atom_mapping/ros/map_storage.h"
#include "atom_mapping/ros/node_diagnostics.h"
#include "atom_mapping/ros/path_service.h"
#include "atom_mapping/ros/read_parameters.h"
#include "atom_mapping/ros/scan_input.h"
#include "atom_mapping/ros/scan_server.h"
#include "atom_mapping/ros/surface_service.h"
#include "atom_mapping/ros/throttled_log.h"

namespace atom_mapping {
namespace {

constexpr std::uint32_t kServiceThreads = 2;
constexpr std::uint32_t kReportQueue = 100;  // messages

Parameters readNodeParameters() {
  XmlRpc::XmlRpcValue values;
  const bool has_any = ros::param::get(ros::this_node::getName(), values);
  return readParameters(has_any ? flatten(values) : ParameterValues());
}

// The node's parts, in the order in which they depend on one another.
class MappingNode {
 public:
  explicit MappingNode(const Parameters& parameters)
      : server_(parameters.mapping),
        storage_(server_, parameters.node.storage),
        queries_(server_, transforms_, parameters.node.services),
        surface_(private_node_, server_, parameters.node.services,
                 [](const std::string& line) { ROS_INFO_STREAM(line); }),
        paths_(server_, transforms_),
        path_publisher_(private_node_.advertise<nav_msgs::Path>("path", 1, true)),
        diagnostics_(node_, server_),
        reports_(private_node_.advertise<ScanReport>("scan_report", kReportQueue, true)),
        publisher_(private_node_, server_, parameters.node.publish),
        input_(node_, server_, transforms_, parameters.node.input,
               [this](const auto& cloud, const ScanOutcome& outcome) { report(cloud, outcome); }) {
    serve<QueryOccupancy>("query_occupancy");
    serve<QuerySignedDistance>("query_signed_distance");
    serve<CheckCollision>("check_collision");
    serve<CastRay>("cast_ray");
    serve<ClearRegion>("clear_region");
    serve<ExtractSurface>("extract_surface", [this](const auto& request) { return surface_.answer(request); });
    serve<MapFile>("save_map", [this](const auto& request) { return storage_.save(request); });
    serve<MapFile>("load_map", [this](const auto& request) { return storage_.load(request); });
    servePaths();
    services_.push_back(private_node_.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>(
        "reset", [this](auto& /*request*/, auto& response) {
          response = queries_.reset();
          return true;
        }));
  }

 private:
  template <class Service>
  void serve(const std::string& name) {
    serve<Service>(name, [this](const auto& request) { return queries_.answer(request); });
  }

  template <class Service, class Answer>
  void serve(const std::string& name, Answer answer) {
    services_.push_back(private_node_.advertiseService<typename Service::Request, typename Service::Response>(
        name, [this, name, answer](auto& request, auto& response) {
          response = answer(request);
          if (!response.success) log_.warn(name, "Refused a request of ~" + name + ": " + response.message);
          return true;
        }));
  }

  void servePaths() {
    services_.push_back(private_node_.advertiseService<PlanPath::Request, PlanPath::Response>(
        "plan_path", [this](auto& request, auto& response) {
          response = paths_.answer(request);
          showPath(response);
          return true;
        }));
    goals_ = node_.subscribe<geometry_msgs::PoseStamped>(
        "goal", 1, [this](const auto& goal) { showPath(paths_.answerGoal(*goal)); });
  }

  void showPath(const PlanPath::Response& planned) {
    if (planned.success) {
      path_publisher_.publish(planned.path);
    } else {
      log_.warn("plan_path", "Planned no path: " + planned.message);
    }
  }

  void report(const sensor_msgs::PointCloud2& cloud, const ScanOutcome& outcome) {
    if (outcome.drop) {
      log_.warn(toString(*outcome.drop), "Dropped a cloud, " + outcome.message);
      return;
    }
    diagnostics_.noteScan(outcome.report, ros::Time::now().toSec() - cloud.header.stamp.toSec());
    reports_.publish(outcome.report);
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
  NodeDiagnostics diagnostics_;
  ros::Publisher reports_;
  MapPublisher publisher_;
  ScanInput input_;
  std::vector<ros::ServiceServer> services_;
  ros::Subscriber goals_;
  tf2_ros::TransformListener listener_{transforms_};  // stops first: it calls what waits for transforms
};

int run() {
  const Parameters parameters = readNodeParameters();
  const MappingNode node(parameters);
  ros::AsyncSpinner spinner(kServiceThreads);
  spinner.start();
  std::signal(SIGTERM, [](int /*signal*/) { ros::requestShutdown(); });  // as SIGINT, which ROS handles: no map is lost
  ros::waitForShutdown();
  return 0;
}

}  // namespace
}  // namespace atom_mapping

int main(int argc, char** argv) {
  ros::init(argc, argv, "atom_mapping");
  try {
    return atom_mapping::run();
  } catch (const std::invalid_argument& fault) {
    ROS_FATAL_STREAM("Cannot start, these parameters are wrong:\n" << fault.what());
    return 1;
  }
}
