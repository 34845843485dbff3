#include "atom_mapping/ros/map_publisher.h"

#include <algorithm>
#include <chrono>

#include "atom_mapping/ros/map_messages.h"

namespace atom_mapping {

MapPublisher::MapPublisher(ros::NodeHandle node, const ScanServer& server, const PublishParameters& parameters)
    : server_(server), parameters_(parameters) {
  using visualization_msgs::Marker;
  advertise<Marker>(node, "atoms", [this](const auto& map) { return toOccupiedMarker(map, parameters_); });
  advertise<sensor_msgs::PointCloud2>(node, "atom_cloud", [](const auto& map) { return toAtomCloud(map); });
  if (parameters.free_atoms) {
    advertise<Marker>(node, "free_atoms", [this](const auto& map) { return toFreeMarker(map, parameters_); });
  }
  thread_ = std::thread([this] { work(); });
}

MapPublisher::~MapPublisher() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

template <class Message, class Make>
void MapPublisher::advertise(ros::NodeHandle& node, const char* name, Make make) {
  constexpr bool kLatched = true;
  topics_.push_back(
      {node.advertise<Message>(name, 1, kLatched),
       [make](const MapSnapshot& map, const ros::Publisher& publisher) { publisher.publish(make(map)); }});
}

bool MapPublisher::isDue(const Topic& topic) const {
  return topic.publisher.getNumSubscribers() > 0 && topic.revision != server_.revision();
}

void MapPublisher::publishDue() {
  const auto is_due = [this](const Topic& topic) { return isDue(topic); };
  if (std::none_of(topics_.begin(), topics_.end(), is_due)) return;
  const MapSnapshot map = takeSnapshot(server_);
  for (Topic& topic : topics_) {
    if (topic.publisher.getNumSubscribers() == 0 || topic.revision == map.revision) continue;
    topic.publish(map, topic.publisher);
    topic.revision = map.revision;
  }
}

void MapPublisher::work() {
  const auto period = std::chrono::duration<double>(parameters_.period);
  std::unique_lock lock(mutex_);
  while (!changed_.wait_for(lock, period, [this] { return stopping_; })) {
    lock.unlock();
    publishDue();
    lock.lock();
  }
}

}  // namespace atom_mapping
