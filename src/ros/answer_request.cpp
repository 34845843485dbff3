#include "atom_mapping/ros/answer_request.h"

#include "atom_mapping/ros/check_request.h"
#include "atom_mapping/ros/frame_name.h"
#include "atom_mapping/ros/pose_conversion.h"

namespace atom_mapping {

std::string faultOf(const std::function<void()>& fill) {
  try {
    fill();
    return "";
  } catch (const Refusal& refusal) {
    return refusal.what();
  } catch (const BadTransform& exception) {
    return std::string("tf's transform from frame_id to the map frame is bad: ") + exception.what();
  } catch (const std::runtime_error& exception) {  // tf2::TransformException, and of stamps too far apart to subtract
    return std::string("frame_id cannot be brought to the map frame: ") + exception.what() +
           "; name a frame that tf knows, or leave it empty for the map frame";
  }
}

void checkSize(const char* array, std::size_t size, std::size_t max_points) {
  if (size <= max_points) return;
  throw Refusal(std::string(array) + " has " + std::to_string(size) + " elements; services/max_points permits " +
                std::to_string(max_points) + ": ask in several requests");
}

atom_map::Pose toMapFrame(const tf2::BufferCore& transforms, const std::string& map_frame, const std::string& frame) {
  const std::string name = withoutSlash(frame);
  if (name.empty() || name == map_frame) return atom_map::Pose::Identity();
  return toPose(transforms.lookupTransform(map_frame, name, ros::Time()).transform);
}

std_srvs::Trigger::Response resetDone() {
  std_srvs::Trigger::Response response;
  response.success = 1;
  response.message = "the map is empty";
  return response;
}

}  // namespace atom_mapping
