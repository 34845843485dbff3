#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <tf2/buffer_core.h>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "atom_mapping/ros/cloud_server.h"

namespace atom_mapping {

// Feeds the server from a thread of its own, cloud by cloud in the order in which they are added.
// Thread safety: any member may be called from any thread.
class ScanWorker {
 public:
  using CloudPtr = sensor_msgs::PointCloud2::ConstPtr;
  using Done = std::function<void(const sensor_msgs::PointCloud2&, const ScanOutcome&)>;

  // Up to `capacity` clouds wait, then the oldest is dropped. Calls `done`, from any thread, for every cloud.
  ScanWorker(CloudServer& server, const tf2::BufferCore& transforms, std::size_t capacity, Done done);
  ~ScanWorker();  // waits for the cloud at hand; those that wait are lost
  ScanWorker(const ScanWorker&) = delete;
  ScanWorker& operator=(const ScanWorker&) = delete;

  void add(const CloudPtr& cloud);
  // Drops all that wait, since time began anew.
  void clear();

 private:
  void work();

  CloudServer& server_;
  const tf2::BufferCore& transforms_;
  std::size_t capacity_;
  Done done_;
  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  std::deque<CloudPtr> clouds_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace atom_mapping
