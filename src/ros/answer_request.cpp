#include "atom_mapping/ros/answer_request.h"

#include <stdexcept>

#include "atom_mapping/ros/check_request.h"
#include "atom_mapping/ros/frame_name.h"
#include "atom_mapping/ros/pose_conversion.h"

namespace atom_mapping {

atom_map::Pose toMapFrame(const std::string& frame, const tf2::BufferCore& transforms, const std::string& map_frame) {
  const std::string name = withoutSlash(frame);
  if (name.empty() || name == map_frame) return atom_map::Pose::Identity();
  try {
    return toPose(transforms.lookupTransform(map_frame, name, ros::Time()).transform);
  } catch (const BadTransform& fault) {
    throw Refusal(std::string("tf's transform from frame_id to the map frame is bad: ") + fault.what());
  } catch (const std::runtime_error& fault) {  // tf2::TransformException, and of stamps too far apart to subtract
    throw Refusal(std::string("frame_id cannot be brought to the map frame: ") + fault.what() +
                  "; name a frame that tf knows, or leave it empty for the map frame");
  }
}

}  // namespace atom_mapping
