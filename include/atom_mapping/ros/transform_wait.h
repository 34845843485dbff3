#pragma once

#include <ros/callback_queue_interface.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2/buffer_core.h>
#include <tf2_ros/message_filter.h>

#include <chrono>
#include <deque>
#include <functional>
#include <string>

#include "atom_mapping/ros/node_parameters.h"

namespace atom_mapping {

// Holds each cloud back until tf can bring it to the map frame: a tf2_ros::MessageFilter, which itself knows no timeout
// and may forget a cloud whose transform comes while it is being added.
// Thread safety: members and handlers run in the one thread that serves the callback queue.
class TransformWait {
 public:
  using CloudPtr = sensor_msgs::PointCloud2::ConstPtr;
  struct Handlers {
    std::function<void(const CloudPtr&)> ready;                         // in the order in which they came
    std::function<void(const CloudPtr&, const std::string&)> given_up;  // with the reason, for a person
  };

  TransformWait(tf2::BufferCore& transforms, std::string map_frame, const InputParameters& parameters,
                ros::CallbackQueueInterface* queue, Handlers handlers);

  void add(const CloudPtr& cloud);

  // Gives up those that waited for too long; to be called now and then.
  void expire();

  // Forgets and returns all that wait.
  std::deque<CloudPtr> clear();

 private:
  using Clock = std::chrono::steady_clock;
  struct Waiting {
    CloudPtr cloud;
    Clock::time_point deadline;
  };

  bool canTransform(const CloudPtr& cloud, std::string* why = nullptr) const;
  bool forget(const CloudPtr& cloud);
  void release(const CloudPtr& cloud);
  void giveUp(const CloudPtr& cloud, const std::string& why);

  const tf2::BufferCore& transforms_;
  std::string map_frame_;
  Clock::duration timeout_;
  Handlers handlers_;
  std::deque<Waiting> waiting_;  // oldest first
  tf2_ros::MessageFilter<sensor_msgs::PointCloud2> filter_;
};

}  // namespace atom_mapping
