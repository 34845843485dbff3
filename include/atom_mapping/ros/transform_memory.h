#pragma once

#include <ros/duration.h>

#include "atom_mapping/ros/node_parameters.h"

namespace atom_mapping {

// How long a node remembers transforms. A cloud's is looked up when the cloud is mapped, and while mapping lags it lies by then
// as far back as the clouds that wait before it take: after the ten seconds that tf2 remembers by itself, clouds whose transform
// had come would be dropped for want of it.
inline ros::Duration transformMemory(const InputParameters& parameters) {
  constexpr double kLongestLag = 60.0;  // s
  return ros::Duration(kLongestLag + parameters.transform_timeout);
}

}  // namespace atom_mapping
