#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2/buffer_core.h>

#include "atom_mapping/ros/cloud_server.h"
#include "atom_mapping/ros/node_parameters.h"
#include "atom_mapping/ros/scan_worker.h"
#include "atom_mapping/ros/time_watch.h"
#include "atom_mapping/ros/transform_wait.h"

namespace atom_mapping {

// A cloud's way into the map: topic `cloud_in`, wait for its transform, worker. Two threads of its own, one that receives
// and one that maps, so that neither waits for services or publishing, nor they for it.
class ScanInput {
 public:
  // Calls `done`, from either thread, for every cloud that came, mapped or dropped.
  ScanInput(const ros::NodeHandle& node, CloudServer& server, tf2::BufferCore& transforms,
            const InputParameters& parameters, const ScanWorker::Done& done);
  ~ScanInput();
  ScanInput(const ScanInput&) = delete;
  ScanInput& operator=(const ScanInput&) = delete;

 private:
  void receive(const sensor_msgs::PointCloud2::ConstPtr& cloud);
  void checkTime();
  void restartTime(const char* what_went_back);
  void drop(const sensor_msgs::PointCloud2& cloud, Drop cause, const std::string& message);

  CloudServer& server_;
  tf2::BufferCore& transforms_;
  ScanWorker::Done done_;
  ros::CallbackQueue queue_;
  ScanWorker worker_;
  TransformWait wait_;
  TimeWatch time_watch_;
  std::string last_frame_;  // of the clouds
  ros::Subscriber subscriber_;
  ros::WallTimer timer_;
  ros::AsyncSpinner spinner_;
};

}  // namespace atom_mapping
