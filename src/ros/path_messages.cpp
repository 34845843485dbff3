#include "atom_mapping/ros/path_messages.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "atom_mapping/ros/pose_conversion.h"

namespace atom_mapping {
namespace {

using atom_map::PathOutcome;
using Eigen::Vector3d;

Eigen::Quaterniond lookingAlong(const Vector3d& way) {
  const double yaw = std::atan2(way.y(), way.x());
  const double pitch = -std::atan2(way.z(), way.head<2>().norm());
  return Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Vector3d::UnitY());
}

geometry_msgs::Pose toPoseMessage(const Vector3d& position, const Eigen::Quaterniond& orientation) {
  geometry_msgs::Pose pose;
  pose.position = toPoint(position);
  pose.orientation.x = orientation.x();
  pose.orientation.y = orientation.y();
  pose.orientation.z = orientation.z();
  pose.orientation.w = orientation.w();
  return pose;
}

std::string at(const Vector3d& point) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "(" << point.x() << ", " << point.y() << ", " << point.z() << ")";
  return text.str();
}

// Of an end where no path may begin or end.
std::string whyNotThere(const atom_map::PlannedPath& path, const atom_map::PathRequest& request) {
  std::ostringstream text;
  text << (path.is_start ? "start " + at(request.start) : "goal " + at(request.goal)) << " is ";
  if (path.outcome == PathOutcome::kUnknown) {
    text << "unknown: no atom lies within two radii; name a place that the sensor has seen";
  } else if (path.outcome == PathOutcome::kOccupied) {
    text << "occupied; name a place in free space";
  } else {
    text << "too tight: the nearest surface is about " << path.room << " m away, robot_radius is "
         << request.preference.robot_radius << " m; name a wider place, or a smaller robot_radius";
  }
  return text.str();
}

}  // namespace

nav_msgs::Path toMessage(const atom_map::PlannedPath& path, const std_msgs::Header& header,
                         const std::optional<Eigen::Quaterniond>& final_orientation) {
  nav_msgs::Path message;
  message.header = header;
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const bool is_last = i + 1 == path.points.size();
    const Vector3d way = is_last ? Vector3d::Zero() : Vector3d(path.points[i + 1] - path.points[i]);
    if (way.norm() > 0.0) orientation = lookingAlong(way);
    if (is_last) orientation = final_orientation.value_or(orientation);
    geometry_msgs::PoseStamped pose;
    pose.header = header;
    pose.pose = toPoseMessage(path.points[i], orientation);
    message.poses.push_back(pose);
  }
  return message;
}

std::string whyNot(const atom_map::PlannedPath& path, const atom_map::PathRequest& request) {
  if (path.outcome != PathOutcome::kNoConnection && path.outcome != PathOutcome::kTimeout) {
    return whyNotThere(path, request);
  }
  std::ostringstream text;
  text << std::setprecision(3)
       << (path.outcome == PathOutcome::kTimeout ? "no path in time" : "no connection: start and goal are not joined")
       << "; the search stopped after " << path.seconds << " s and " << path.expanded
       << " nodes, nearest to the goal at " << at(path.nearest) << ", " << (path.nearest - request.goal).norm()
       << " m short of it; "
       << (path.outcome == PathOutcome::kTimeout
               ? "give it a longer timeout"
               : "let the sensor see the space between, or name a smaller robot_radius");
  return text.str();
}

}  // namespace atom_mapping
