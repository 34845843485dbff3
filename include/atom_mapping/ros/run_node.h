#pragma once

#include <XmlRpcValue.h>
#include <ros/ros.h>

#include <csignal>
#include <stdexcept>

#include "atom_mapping/base/keep_memory.h"
#include "atom_mapping/ros/parameter_values.h"

namespace atom_mapping {

// Makes a Node from read(values), the values being those under the node's `~`, and serves its callbacks until shutdown.
// The program's exit code: 1 where a parameter is wrong, which the log tells.
template <class Node, class Read>
int runNode(Read&& read) {
  constexpr std::uint32_t kServiceThreads = 4;  // a long plan or extraction leaves some for short questions
  atom_map::keepFreedMemory();
  const ros::NodeHandle keep;  // with the last one the log goes, and a Node that fails to start takes its own along
  try {
    XmlRpc::XmlRpcValue values;
    const bool has_any = ros::param::get(ros::this_node::getName(), values);
    const Node node(read(has_any ? flatten(values) : ParameterValues()));
    ros::AsyncSpinner spinner(kServiceThreads);
    spinner.start();
    std::signal(SIGTERM, [](int /*signal*/) { ros::requestShutdown(); });  // as SIGINT, which ROS handles
    ros::waitForShutdown();
    return 0;
  } catch (const std::invalid_argument& fault) {
    ROS_FATAL_STREAM("Cannot start, these parameters are wrong:\n" << fault.what());
    return 1;
  }
}

}  // namespace atom_mapping
