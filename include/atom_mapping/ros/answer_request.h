// What the answers of all services have in common.
#pragma once

#include <std_srvs/Trigger.h>
#include <tf2/buffer_core.h>

#include <functional>
#include <string>

#include "atom_mapping/base/types.h"

namespace atom_mapping {

// Calls fill(); what was wrong with the request if it threw, else empty.
std::string faultOf(const std::function<void()>& fill);

// Answers a request by fill(response), or by what was wrong with it.
template <class Response, class Fill>
Response answered(Fill&& fill) {
  Response response;
  const std::string fault = faultOf([&] { fill(response); });
  if (!fault.empty()) response = Response();
  response.success = fault.empty() ? 1 : 0;
  response.message = fault;
  return response;
}

// Throws a Refusal where an array of a request has more elements than services/max_points.
void checkSize(const char* array, std::size_t size, std::size_t max_points);

// From a request's frame, as tf knows it last, to the map frame. An empty name is the map frame.
atom_map::Pose toMapFrame(const tf2::BufferCore& transforms, const std::string& map_frame, const std::string& frame);

// That the map was reset.
std_srvs::Trigger::Response resetDone();

}  // namespace atom_mapping
