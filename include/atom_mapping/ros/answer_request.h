// What the services share: a refusal becomes an answer, and a request's frame a pose.
#pragma once

#include <tf2/buffer_core.h>

#include <stdexcept>
#include <string>

#include "atom_mapping/ros/check_request.h"
#include "atom_mapping/ros/pose_conversion.h"

namespace atom_mapping {

// Answers a request by `fill`, or by what was wrong with it.
template <class Response, class Fill>
Response answered(Fill&& fill) {
  Response response;
  std::string fault;
  try {
    fill(response);
    response.success = 1;
    return response;
  } catch (const Refusal& refusal) {
    fault = refusal.what();
  } catch (const BadTransform& exception) {
    fault = std::string("tf's transform from frame_id to the map frame is bad: ") + exception.what();
  } catch (const std::runtime_error& exception) {  // tf2::TransformException, and of stamps too far apart to subtract
    fault = std::string("frame_id cannot be brought to the map frame: ") + exception.what() +
            "; name a frame that tf knows, or leave it empty for the map frame";
  }
  Response refused;
  refused.success = 0;
  refused.message = fault;
  return refused;
}

// Of a request's frame, as tf knows it last; an empty name is the map frame's. Throws BadTransform, or what tf throws.
atom_map::Pose toMapFrame(const std::string& frame, const tf2::BufferCore& transforms, const std::string& map_frame);

}  // namespace atom_mapping
