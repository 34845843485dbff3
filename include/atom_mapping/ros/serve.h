// Services of a node's `~`, answered by the answer() and reset() of MapQueries or BaselineQueries.
#pragma once

#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <string>

#include "atom_mapping/ros/throttled_log.h"

namespace atom_mapping {

// Refused requests go to the log. What is passed must live as long as the server that is returned.
template <class Service, class Queries>
ros::ServiceServer serve(ros::NodeHandle& private_node, const std::string& name, Queries& queries, ThrottledLog& log) {
  return private_node.advertiseService<typename Service::Request, typename Service::Response>(
      name, [name, &queries, &log](auto& request, auto& response) {
        response = queries.answer(request);
        if (!response.success) log.warn(name, "Refused a request of ~" + name + ": " + response.message);
        return true;
      });
}

template <class Queries>
ros::ServiceServer serveReset(ros::NodeHandle& private_node, Queries& queries) {
  return private_node.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>(
      "reset", [&queries](auto& /*request*/, auto& response) {
        response = queries.reset();
        return true;
      });
}

}  // namespace atom_mapping
