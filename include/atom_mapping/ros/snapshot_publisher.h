#pragma once

#include <ros/ros.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "atom_mapping/ros/cloud_server.h"

namespace atom_mapping {

// Publishes what is made of a map's snapshot on latched topics, from a thread of its own: once a period, where the map
// changed and somebody listens. A Snapshot has the `revision` that it is of.
template <class Snapshot>
class SnapshotPublisher {
 public:
  using Take = std::function<Snapshot()>;

  // `period` in seconds of wall time.
  SnapshotPublisher(const CloudServer& server, double period, Take take)
      : server_(server), period_(period), take_(std::move(take)) {}

  ~SnapshotPublisher() {
    if (!thread_.joinable()) return;
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }

  SnapshotPublisher(const SnapshotPublisher&) = delete;
  SnapshotPublisher& operator=(const SnapshotPublisher&) = delete;

  // Before start(). `make` turns a snapshot into a message.
  template <class Message, class Make>
  void advertise(ros::NodeHandle& node, const char* name, Make make) {
    constexpr bool kLatched = true;
    topics_.push_back({node.advertise<Message>(name, 1, kLatched),
                       [make](const Snapshot& map, const ros::Publisher& publisher) { publisher.publish(make(map)); }});
  }

  void start() {
    thread_ = std::thread([this] { work(); });
  }

 private:
  struct Topic {
    ros::Publisher publisher;
    std::function<void(const Snapshot&, const ros::Publisher&)> publish;
    std::uint64_t revision = 0;  // published last; the map's first is 1
  };

  bool isDue(const Topic& topic) const {
    return topic.publisher.getNumSubscribers() > 0 && topic.revision != server_.revision();
  }

  void publishDue() {
    const auto is_due = [this](const Topic& topic) { return isDue(topic); };
    if (std::none_of(topics_.begin(), topics_.end(), is_due)) return;
    const Snapshot map = take_();
    for (Topic& topic : topics_) {
      if (topic.publisher.getNumSubscribers() == 0 || topic.revision == map.revision) continue;
      topic.publish(map, topic.publisher);
      topic.revision = map.revision;
    }
  }

  void work() {
    const auto period = std::chrono::duration<double>(period_);
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, period, [this] { return stopping_; })) {
      lock.unlock();
      publishDue();
      lock.lock();
    }
  }

  const CloudServer& server_;
  double period_;
  Take take_;
  std::vector<Topic> topics_;
  std::mutex mutex_;  // of what follows
  std::condition_variable changed_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace atom_mapping
