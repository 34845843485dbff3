#pragma once

#include <ros/ros.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "atom_mapping/ros/map_snapshot.h"
#include "atom_mapping/ros/node_parameters.h"
#include "atom_mapping/ros/scan_server.h"

namespace atom_mapping {

// Publishes ~atoms, ~free_atoms and ~atom_cloud, latched, from a thread of its own: once a period, where the map changed
// and somebody listens.
class MapPublisher {
 public:
  MapPublisher(ros::NodeHandle node, const ScanServer& server, const PublishParameters& parameters);
  ~MapPublisher();
  MapPublisher(const MapPublisher&) = delete;
  MapPublisher& operator=(const MapPublisher&) = delete;

 private:
  struct Topic {
    ros::Publisher publisher;
    std::function<void(const MapSnapshot&, const ros::Publisher&)> publish;
    std::uint64_t revision = 0;  // published last; the map's first is 1
  };

  template <class Message, class Make>
  void advertise(ros::NodeHandle& node, const char* name, Make make);
  bool isDue(const Topic& topic) const;
  void publishDue();
  void work();

  const ScanServer& server_;
  PublishParameters parameters_;
  std::vector<Topic> topics_;
  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace atom_mapping
