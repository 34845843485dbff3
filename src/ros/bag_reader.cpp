#include "atom_mapping/ros/bag_reader.h"

#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include "atom_mapping/ros/time_watch.h"

namespace atom_mapping {
namespace {

// Transforms are read so far ahead of the clouds: whoever localizes may publish them late.
const ros::Duration kAhead(10.0);

const char* const kUsualTopic = "/velodyne_points";

// Calls read(); whatever rosbag or the messages' reading throws becomes a BadBag.
template <class Read>
auto guarded(const std::string& file, Read&& read) {
  try {
    return read();
  } catch (const BadBag&) {
    throw;
  } catch (const rosbag::BagUnindexedException&) {
    throw BadBag(file + " has no index, its recording was cut short: repair it with `rosbag reindex " + file + "`");
  } catch (const std::exception& error) {
    throw BadBag(file + " is cut short or damaged, `rosbag reindex " + file + "` may repair it: " + error.what());
  }
}

std::vector<std::string> cloudTopics(const rosbag::Bag& bag) {
  rosbag::View view(bag, rosbag::TypeQuery("sensor_msgs/PointCloud2"));
  std::vector<std::string> topics;
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) topics.push_back(connection->topic);
  std::sort(topics.begin(), topics.end());
  topics.erase(std::unique(topics.begin(), topics.end()), topics.end());
  return topics;
}

std::string allTopics(const rosbag::Bag& bag) {
  rosbag::View view(bag);
  std::string list;
  for (const rosbag::ConnectionInfo* connection : view.getConnections()) {
    list += (list.empty() ? "" : ", ") + connection->topic + " (" + connection->datatype + ")";
  }
  return list.empty() ? "none" : list;
}

std::string join(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

// Which of a bag's topics of clouds is meant; empty if none is.
std::string choose(const std::vector<std::string>& topics, const std::string& wanted) {
  const auto contains = [&](const std::string& topic) {
    return std::find(topics.begin(), topics.end(), topic) != topics.end();
  };
  if (!wanted.empty()) return contains(wanted) ? wanted : "";
  if (topics.size() == 1) return topics.front();
  return contains(kUsualTopic) ? kUsualTopic : "";
}

}  // namespace

BagReader::BagReader(const std::string& file, const std::string& cloud_topic) : file_(file) {
  open();
  guarded(file_, [&] {
    chooseTopic(cloud_topic);
    startTransforms();
  });
}

void BagReader::open() {
  std::ifstream in(file_);
  if (!in) throw BadBag("cannot open " + file_ + ": " + std::generic_category().message(errno));
  std::string magic(7, '\0');
  in.read(magic.data(), 7);
  if (magic != "#ROSBAG") throw BadBag(file_ + " is no bag of ROS 1");
  guarded(file_, [&] {
    bag_.open(file_, rosbag::bagmode::Read);
    ahead_.open(file_, rosbag::bagmode::Read);
  });
}

void BagReader::chooseTopic(const std::string& wanted) {
  const std::vector<std::string> topics = cloudTopics(bag_);
  cloud_topic_ = choose(topics, wanted);
  if (cloud_topic_.empty()) {
    if (topics.empty()) throw BadBag(file_ + " holds no sensor_msgs/PointCloud2; its topics: " + allTopics(bag_));
    if (wanted.empty()) throw BadBag(file_ + " holds several topics of clouds, choose one by --topic: " + join(topics));
    throw BadBag(file_ + " holds no clouds on " + wanted + ", but on " + join(topics));
  }
  cloud_view_.addQuery(bag_, rosbag::TopicQuery(cloud_topic_));
  next_cloud_ = cloud_view_.begin();
  clouds_ = cloud_view_.size();
}

void BagReader::startTransforms() {
  rosbag::View whole(bag_);
  const ros::Duration length = whole.size() == 0 ? ros::Duration() : whole.getEndTime() - whole.getBeginTime();
  transforms_.emplace(length + ros::Duration(60.0));  // none is forgotten, wherever in the bag it was recorded

  readStaticTransforms();
  transform_view_.addQuery(ahead_, rosbag::TopicQuery(std::vector<std::string>{"/tf", "tf"}));
  next_transform_ = transform_view_.begin();
  has_transforms_ = has_transforms_ || transform_view_.size() > 0;
}

void BagReader::readStaticTransforms() {
  rosbag::View view(ahead_, rosbag::TopicQuery(std::vector<std::string>{"/tf_static", "tf_static"}));
  has_transforms_ = view.size() > 0;
  for (const rosbag::MessageInstance& recorded : view) {
    const auto message = recorded.instantiate<tf2_msgs::TFMessage>();
    if (!message) continue;
    for (const auto& transform : message->transforms) transforms_->setTransform(transform, "bag", true);
  }
}

// Up to those that were recorded with a cloud and, as long as time goes on, some seconds after it: transforms of a time that
// began anew would lie among those of before.
void BagReader::readTransforms(const ros::Time& recorded) {
  for (; next_transform_ != transform_view_.end() && next_transform_->getTime() <= recorded + kAhead;
       ++next_transform_) {
    const auto message = next_transform_->instantiate<tf2_msgs::TFMessage>();
    if (!message) continue;
    const bool is_ahead = next_transform_->getTime() > recorded;
    for (const auto& transform : message->transforms) {
      if (is_ahead && goesBack(transform)) return;
    }
    for (const auto& transform : message->transforms) {
      transforms_->setTransform(transform, "bag", false);
      last_[transform.child_frame_id] = transform.header.stamp;
    }
  }
}

bool BagReader::goesBack(const geometry_msgs::TransformStamped& transform) const {
  const auto last = last_.find(transform.child_frame_id);
  return last != last_.end() && transform.header.stamp.toSec() + TimeWatch::kTolerance < last->second.toSec();
}

void BagReader::restartTime() {
  guarded(file_, [&] {
    transforms_->clear();  // which keeps the static ones
    last_.clear();
    next_transform_ = transform_view_.begin();
    while (next_transform_ != transform_view_.end() && next_transform_->getTime() < recorded_.front())
      ++next_transform_;
    readTransforms(recorded_.back());
  });
}

void BagReader::expectUsable() const {
  if (!has_transforms_) throw BadBag(file_ + " holds no tf: record /tf and /tf_static beside the clouds");
  if (clouds_ == 0) throw BadBag(file_ + " holds not one cloud on " + cloud_topic_);
}

std::string BagReader::frames() const {
  std::vector<std::string> names;
  transforms_->_getFrameStrings(names);
  std::sort(names.begin(), names.end());
  return join(names);
}

sensor_msgs::PointCloud2ConstPtr BagReader::next() {
  return guarded(file_, [&]() -> sensor_msgs::PointCloud2ConstPtr {
    if (next_cloud_ == cloud_view_.end()) return nullptr;
    const rosbag::MessageInstance recorded = *next_cloud_;
    recorded_.push_back(recorded.getTime());
    if (recorded_.size() > TimeWatch::kClouds) recorded_.pop_front();
    readTransforms(recorded.getTime());
    auto cloud = recorded.instantiate<sensor_msgs::PointCloud2>();
    if (!cloud) throw BadBag(file_ + " holds a message on " + cloud_topic_ + " that is no sensor_msgs/PointCloud2");
    ++next_cloud_;
    return cloud;
  });
}

}  // namespace atom_mapping
