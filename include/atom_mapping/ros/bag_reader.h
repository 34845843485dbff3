#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2/buffer_core.h>

#include <deque>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

namespace atom_mapping {

// A bag that cannot be used; what() says which, why, and what to do, in one line.
class BadBag : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Reads a bag's clouds in the order of their recording, and the transforms that belong to them. Needs no roscore.
class BagReader {
 public:
  // `cloud_topic` empty: the bag's only PointCloud2 topic, or /velodyne_points among several. Throws BadBag.
  BagReader(const std::string& file, const std::string& cloud_topic);

  // The next cloud, once transforms() hold what was recorded up to some seconds after it, or up to where their stamps begin
  // anew; null at the end. Throws BadBag where the bag is damaged.
  sensor_msgs::PointCloud2ConstPtr next();

  // Time began anew with the first of the last TimeWatch::kClouds clouds: forgets the transforms that were recorded before it.
  // Throws BadBag.
  void restartTime();

  // Throws BadBag where there is nothing to map: not one cloud, or no transforms.
  void expectUsable() const;

  const tf2::BufferCore& transforms() const { return *transforms_; }
  std::string frames() const;  // that the transforms read so far tell of, such as "map, velodyne"
  const std::string& cloudTopic() const { return cloud_topic_; }
  std::size_t clouds() const { return clouds_; }

 private:
  void open();
  void chooseTopic(const std::string& wanted);
  void startTransforms();
  void readStaticTransforms();
  void readTransforms(const ros::Time& recorded);
  bool goesBack(const geometry_msgs::TransformStamped& transform) const;

  std::string file_;
  std::string cloud_topic_;
  std::size_t clouds_ = 0;
  bool has_transforms_ = false;
  rosbag::Bag bag_;
  rosbag::Bag ahead_;  // the same file: a bag holds one uncompressed chunk, and transforms are read ahead of the clouds
  rosbag::View cloud_view_;
  rosbag::View transform_view_;
  rosbag::View::iterator next_cloud_;
  rosbag::View::iterator next_transform_;
  std::optional<tf2::BufferCore> transforms_;
  std::map<std::string, ros::Time> last_;  // stamp that was read of each child frame's transforms
  std::deque<ros::Time> recorded_;         // when the last clouds were
};

}  // namespace atom_mapping
