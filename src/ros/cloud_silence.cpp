#include "atom_mapping/ros/cloud_silence.h"

#include <sensor_msgs/PointCloud2.h>

#include <set>

namespace atom_mapping {

std::string describeSilence(const std::string& topic, const ros::master::V_TopicInfo& advertised,
                            const std::string& own_name) {
  std::set<std::string> others;
  bool is_advertised = false;
  for (const ros::master::TopicInfo& info : advertised) {
    is_advertised = is_advertised || info.name == topic;
    const bool is_cloud = info.datatype == ros::message_traits::datatype<sensor_msgs::PointCloud2>();
    if (is_cloud && info.name != topic && info.name.rfind(own_name + "/", 0) != 0) others.insert(info.name);
  }
  std::string text = "no cloud on " + topic + " yet" + (is_advertised ? "" : ", which nobody publishes");
  if (is_advertised || others.empty()) return text;
  std::string listed;
  for (const std::string& other : others) listed += (listed.empty() ? "" : ", ") + other;
  return text + "; there are clouds on " + listed + ": remap cloud_in, or give the launch file its cloud_topic";
}

}  // namespace atom_mapping
