#include "atom_mapping/ros/path_service.h"

#include <cmath>
#include <thread>

#include "atom_mapping/ros/answer_request.h"
#include "atom_mapping/ros/check_request.h"
#include "atom_mapping/ros/path_messages.h"
#include "atom_mapping/ros/pose_conversion.h"

namespace atom_mapping {
namespace {

using atom_map::AtomMap;
using Eigen::Vector3d;

constexpr int kHeights = 80;         // tried on each side of the sensor's
constexpr double kHeightStep = 0.5;  // atomic radii

float checkedUpTo(const std::string& where, float value, float greatest) {
  if (checkedLength(where, value) <= greatest) return value;
  throw Refusal(where + " is " + std::to_string(value) + "; it must be at most " + std::to_string(greatest));
}

// Nothing for a quaternion that is none, as of a goal that leaves its orientation out.
std::optional<Eigen::Quaterniond> orientationOf(const geometry_msgs::Pose& pose) {
  const Eigen::Quaterniond q(pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z);
  if (!(std::abs(q.norm() - 1.0) < 1e-3)) return std::nullopt;
  return q.normalized();
}

}  // namespace

PlanPath::Response PathService::answer(const PlanPath::Request& request) const {
  return answered<PlanPath::Response>([&](auto& response) { fill(request, response); });
}

PlanPath::Response PathService::answerGoal(const geometry_msgs::PoseStamped& goal) const {
  return answered<PlanPath::Response>([&](auto& response) { fill(requestFor(goal), response); });
}

void PathService::fill(const PlanPath::Request& request, PlanPath::Response& response) const {
  const auto radius = static_cast<float>(server_.parameters().radius);
  atom_map::PathRequest path;
  const auto place = [&](const char* name, const geometry_msgs::PoseStamped& pose, atom_map::Pose& to_map) {
    to_map = toMapFrame(pose.header.frame_id, transforms_, server_.mapFrame());
    return Vector3d(to_map * checkedPoint(name, pose.pose.position));
  };
  atom_map::Pose to_map;
  path.start = place("start.pose.position", request.start, to_map);
  path.goal = place("goal.pose.position", request.goal, to_map);
  path.preference.robot_radius = checkedUpTo("robot_radius", request.robot_radius, kLargestLength * radius);
  path.preference.surface_distance = checkedUpTo("surface_distance", request.surface_distance, kLargestLength * radius);
  path.preference.surface_weight = checkedUpTo("surface_weight", request.surface_weight, 1e6F);
  const auto timeout = static_cast<double>(checkedUpTo("timeout", request.timeout, kLongestTime));
  path.timeout = timeout > 0.0 ? timeout : server_.parameters().planning.timeout;
  path.shortcut = server_.parameters().planning.shortcut;

  const auto read = [this](const std::function<void(const AtomMap&)>& use) {
    server_.read(use);
    std::this_thread::yield();  // to whoever else waits for the map
  };
  const atom_map::PlannedPath planned = atom_map::planPath(read, path, server_.parameters().gaussian_process);
  if (planned.outcome != atom_map::PathOutcome::kFound) throw Refusal(whyNot(planned, path));
  auto orientation = orientationOf(request.goal.pose);
  if (orientation) orientation = Eigen::Quaterniond(to_map.linear()) * *orientation;
  std_msgs::Header header;
  header.frame_id = server_.mapFrame();
  header.stamp = server_.newest();
  response.path = toMessage(planned, header, orientation);
  response.length = static_cast<float>(planned.length);
  response.cost = static_cast<float>(planned.cost);
  response.expanded = planned.expanded;
}

PlanPath::Request PathService::requestFor(const geometry_msgs::PoseStamped& goal) const {
  const auto sensor = server_.sensorPose();
  if (!sensor) throw Refusal("the goal has no start: no cloud has been mapped yet; wait for the first");
  const auto parameters = server_.parameters().planning;
  PlanPath::Request request;
  request.start.pose.position = toPoint(sensor->translation());
  request.goal = goal;
  request.robot_radius = static_cast<float>(parameters.robot_radius);
  request.surface_distance = static_cast<float>(parameters.surface_distance);
  request.surface_weight = static_cast<float>(parameters.surface_weight);
  if (goal.pose.position.z == 0.0) liftGoal(sensor->translation().z(), request);
  return request;
}

// Upright in the map frame; leaves a goal as it is where no height will do.
void PathService::liftGoal(double height, PlanPath::Request& request) const {
  const atom_map::Pose to_map = toMapFrame(request.goal.header.frame_id, transforms_, server_.mapFrame());
  Vector3d goal = to_map * checkedPoint("goal.pose.position", request.goal.pose.position);
  const auto fits = [&] {
    return server_.read([&](const AtomMap& map) {
      const auto outcome = atom_map::examine(map, goal, request.robot_radius, server_.parameters().gaussian_process);
      return outcome == atom_map::PathOutcome::kFound;
    });
  };
  if (fits()) return;
  for (int i = 0; i < 2 * kHeights; ++i) {
    const int steps = (i + 1) / 2 * (i % 2 == 0 ? 1 : -1);
    goal.z() = height + steps * kHeightStep * server_.parameters().radius;
    if (!fits()) continue;
    request.goal.pose.position = toPoint(to_map.inverse() * goal);
    return;
  }
}

}  // namespace atom_mapping
