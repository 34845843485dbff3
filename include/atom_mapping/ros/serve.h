// Services of a node's `~`.
#pragma once

#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include <string>

#include "atom_mapping/ros/throttled_log.h"

namespace atom_mapping {

// Answers by answer(request); a refusal goes to the log, which must live as long as what is returned.
template <class Service, class Answer>
ros::ServiceServer serve(ros::NodeHandle& private_node, const std::string& name, Answer answer, ThrottledLog& log) {
  return private_node.advertiseService<typename Service::Request, typename Service::Response>(
      name, [name, answer, &log](auto& request, auto& response) {
        response = answer(request);
        if (!response.success) log.warn(name, "Refused a request of ~" + name + ": " + response.message);
        return true;
      });
}

// Answers ~reset by queries.reset(); `queries` must live as long as what is returned.
template <class Queries>
ros::ServiceServer serveReset(ros::NodeHandle& private_node, Queries& queries) {
  return private_node.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>(
      "reset", [&queries](auto& /*request*/, auto& response) {
        response = queries.reset();
        return true;
      });
}

}  // namespace atom_mapping
