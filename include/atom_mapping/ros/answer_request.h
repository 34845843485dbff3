// What the services share: what goes wrong becomes an answer, and a request's frame a pose.
#pragma once

#include <tf2/buffer_core.h>

#include <exception>
#include <string>

#include "atom_mapping/base/types.h"

namespace atom_mapping {

// Answers a request by `fill`, or by what was wrong with it.
template <class Response, class Fill>
Response answered(Fill&& fill) {
  Response response;
  try {
    fill(response);
    response.success = 1;
    return response;
  } catch (const std::exception& fault) {  // Refusal; of files, of the extraction
    Response refused;
    refused.success = 0;
    refused.message = fault.what();
    return refused;
  }
}

// Of a request's frame, as tf knows it last; an empty name is the map frame's. Throws Refusal.
atom_map::Pose toMapFrame(const std::string& frame, const tf2::BufferCore& transforms, const std::string& map_frame);

}  // namespace atom_mapping
