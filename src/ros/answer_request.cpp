#include "atom_mapping/ros/answer_request.h"

#include "atom_mapping/ros/frame_name.h"

namespace atom_mapping {

atom_map::Pose toMapFrame(const std::string& frame, const tf2::BufferCore& transforms, const std::string& map_frame) {
  const std::string name = withoutSlash(frame);
  if (name.empty() || name == map_frame) return atom_map::Pose::Identity();
  return toPose(transforms.lookupTransform(map_frame, name, ros::Time()).transform);
}

}  // namespace atom_mapping
