#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Transform.h>

#include <stdexcept>

#include "atom_mapping/base/types.h"

namespace atom_mapping {

// Metres; coordinates beyond are taken for errors (UTM reaches 1e7).
constexpr double kFarthest = 1e8;

// A transform that is no rigid motion, or reaches beyond kFarthest; what() says which.
class BadTransform : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

geometry_msgs::Point toPoint(const Eigen::Vector3d& p);

// Throws BadTransform.
atom_map::Pose toPose(const geometry_msgs::Transform& transform);

}  // namespace atom_mapping
