// What the rostests hold in their hands: the node's topics and services, as a robot has them.
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/Point.h>
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "atom_mapping/ScanReport.h"
#include "atom_mapping/ros/pose_conversion.h"
#include "simulated_input.h"

namespace atom_mapping {

class NodeClient {
 public:
  static constexpr double kPatience = 30.0;  // s of wall time, far more than anything takes

  NodeClient() {
    clouds_ = node_.advertise<sensor_msgs::PointCloud2>("/velodyne_points", 100);
    transforms_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 100);
    reports_subscriber_ = node_.subscribe<ScanReport>("/atom_mapping/scan_report", 100,
                                                      [this](const auto& report) { reports.push_back(*report); });
    diagnostics_ = node_.subscribe<diagnostic_msgs::DiagnosticArray>("/diagnostics", 100, [this](const auto& array) {
      for (const auto& status : array->status) {
        statuses[status.name] = status;
        for (const auto& entry : status.values) diagnostics[entry.key] = entry.value;
      }
      ++diagnostics_count;
    });
    log_ = node_.subscribe<rosgraph_msgs::Log>("/rosout", 100, [this](const auto& line) {
      if (line->name == "/atom_mapping" && line->level >= rosgraph_msgs::Log::WARN) warnings.push_back(line->msg);
    });
  }

  // Handles messages until the condition holds; false if it never does.
  template <class Condition>
  static bool waitUntil(Condition condition) {
    const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kPatience);
    while (!condition()) {
      if (!ros::ok() || ros::WallTime::now() > deadline) return false;
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
    }
    return true;
  }

  bool waitForNode() {
    return waitUntil([this] {
      return clouds_.getNumSubscribers() > 0 && transforms_.getNumSubscribers() > 0 &&
             reports_subscriber_.getNumPublishers() > 0 && diagnostics_count > 0;
    });
  }

  // Nodes that listen to the clouds.
  std::uint32_t subscribers() const { return clouds_.getNumSubscribers(); }

  bool waitForReports(std::size_t count) {
    return waitUntil([&] { return reports.size() >= count; });
  }

  // For a diagnostic that counts, such as "dropped: malformed".
  bool waitForCount(const std::string& key, int count) {
    return waitUntil([&] { return this->count(key) >= count; });
  }

  int count(const std::string& key) const {
    const auto found = diagnostics.find(key);
    return found == diagnostics.end() ? -1 : std::stoi(found->second);
  }

  // Exactly one line of the node's log, warnings and worse, holds the text.
  void expectOneWarning(const std::string& text) {
    const auto count = [&] {
      return std::count_if(warnings.begin(), warnings.end(),
                           [&](const std::string& line) { return line.find(text) != std::string::npos; });
    };
    EXPECT_TRUE(waitUntil([&] { return count() > 0; })) << text;
    EXPECT_EQ(count(), 1) << text;
  }

  void publish(const sensor_msgs::PointCloud2& cloud) { clouds_.publish(cloud); }

  void publish(const geometry_msgs::TransformStamped& transform) {
    tf2_msgs::TFMessage message;
    message.transforms.push_back(transform);
    transforms_.publish(message);
  }

  // The answer of a service of a node; fails the test when there is none.
  template <class Service>
  static typename Service::Response call(const std::string& name, const typename Service::Request& request,
                                         const std::string& node = "atom_mapping") {
    const std::string service = "/" + node + "/" + name;
    typename Service::Response response;
    EXPECT_TRUE((ros::service::waitForService(service, ros::Duration(-1.0)) &&
                 ros::service::call(service, const_cast<typename Service::Request&>(request), response)))
        << service << " does not answer";
    return response;
  }

  // The first message of a topic that is as wanted.
  template <class Message, class IsWanted>
  Message receive(const std::string& topic, IsWanted is_wanted) {
    typename Message::ConstPtr wanted;
    const auto subscriber = node_.subscribe<Message>(topic, 1, [&](const typename Message::ConstPtr& message) {
      if (is_wanted(*message)) wanted = message;
    });
    EXPECT_TRUE(waitUntil([&] { return wanted != nullptr; })) << "nothing on " << topic;
    return wanted ? *wanted : Message();
  }

  template <class Message>
  Message receive(const std::string& topic) {
    return receive<Message>(topic, [](const Message&) { return true; });
  }

  std::vector<ScanReport> reports;
  std::map<std::string, std::string> diagnostics;                     // values by their keys
  std::map<std::string, diagnostic_msgs::DiagnosticStatus> statuses;  // by name, such as "atom_mapping: map"
  int diagnostics_count = 0;
  std::vector<std::string> warnings;

 private:
  ros::NodeHandle node_;
  ros::Publisher clouds_;
  ros::Publisher transforms_;
  ros::Subscriber reports_subscriber_;
  ros::Subscriber diagnostics_;
  ros::Subscriber log_;
};

inline Eigen::Vector3d toVector(const geometry_msgs::Point& p) {
  return {p.x, p.y, p.z};
}

}  // namespace atom_mapping
