#include "atom_mapping/ros/pose_conversion.h"

#include <cmath>
#include <sstream>

namespace atom_mapping {
namespace {

constexpr double kNormTolerance = 1e-3;  // of a quaternion, as float drivers leave it

}  // namespace

geometry_msgs::Point toPoint(const Eigen::Vector3d& p) {
  geometry_msgs::Point point;
  point.x = p.x();
  point.y = p.y();
  point.z = p.z();
  return point;
}

atom_map::Pose toPose(const geometry_msgs::Transform& transform) {
  const auto& t = transform.translation;
  const auto& q = transform.rotation;
  const Eigen::Vector3d translation(t.x, t.y, t.z);
  const Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
  std::ostringstream fault;
  if (!(translation.cwiseAbs().maxCoeff() <= kFarthest)) {
    fault << "its translation is (" << translation.transpose() << ") m; each part must lie within " << kFarthest
          << " m";
    throw BadTransform(fault.str());
  }
  if (!(std::abs(rotation.norm() - 1.0) <= kNormTolerance)) {
    fault << "its quaternion has the norm " << rotation.norm() << "; it must be 1";
    throw BadTransform(fault.str());
  }
  return Eigen::Translation3d(translation) * rotation.normalized();
}

}  // namespace atom_mapping
