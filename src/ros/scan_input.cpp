#include "atom_mapping/ros/scan_input.h"

#include "atom_mapping/ros/frame_name.h"

namespace atom_mapping {
namespace {

constexpr double kCheckPeriod = 0.05;         // s of wall time
constexpr std::uint32_t kReceiveQueue = 100;  // clouds; receiving is quick, so that they never wait there for long

ros::NodeHandle withQueue(ros::NodeHandle node, ros::CallbackQueue& queue) {
  node.setCallbackQueue(&queue);
  return node;
}

}  // namespace

ScanInput::ScanInput(const ros::NodeHandle& node, CloudServer& server, tf2::BufferCore& transforms,
                     const InputParameters& parameters, const ScanWorker::Done& done)
    : server_(server),
      transforms_(transforms),
      done_(done),
      worker_(server, transforms, parameters.queue_size, done),
      wait_(transforms, server.mapFrame(), parameters, &queue_,
            {[this](const auto& cloud) { worker_.add(cloud); },
             [this](const auto& cloud, const std::string& why) {
               drop(*cloud, Drop::kNoTransform,
                    "no transform in time from " + cloud->header.frame_id + " to " + server_.mapFrame() + ": " + why +
                        "; publish it, or set map_frame to a frame that tf knows");
             }}),
      spinner_(1, &queue_) {
  ros::NodeHandle own = withQueue(node, queue_);
  subscriber_ = own.subscribe("cloud_in", kReceiveQueue, &ScanInput::receive, this, ros::TransportHints().tcpNoDelay());
  timer_ = own.createWallTimer(ros::WallDuration(kCheckPeriod), [this](const ros::WallTimerEvent&) {
    checkTime();
    wait_.expire();
  });
  spinner_.start();
}

ScanInput::~ScanInput() {
  spinner_.stop();
  subscriber_.shutdown();
  timer_.stop();
}

void ScanInput::receive(const sensor_msgs::PointCloud2::ConstPtr& cloud) {
  checkTime();
  if (time_watch_.stampsWentBack(cloud->header.stamp, server_.newest())) restartTime("the clouds' stamps");
  last_frame_ = withoutSlash(cloud->header.frame_id);
  wait_.add(cloud);
}

void ScanInput::checkTime() {
  if (time_watch_.clockWentBack(ros::Time::now())) restartTime("the clock");
}

void ScanInput::restartTime(const char* what_went_back) {
  ROS_WARN("Time began anew, %s went back: forgetting transforms and waiting clouds, keeping the map.", what_went_back);
  for (const auto& cloud : wait_.clear()) drop(*cloud, Drop::kTimeJump, "time jumped back while it waited");
  worker_.clear();
  // tf2_ros::TransformListener clears the buffer too; what it has heard since must stay.
  const ros::Time old = server_.newest();
  if (!old.isZero() && transforms_.canTransform(server_.mapFrame(), last_frame_, old)) transforms_.clear();
  server_.restartTime();
}

void ScanInput::drop(const sensor_msgs::PointCloud2& cloud, Drop cause, const std::string& message) {
  done_(cloud, server_.drop(cause, message));
}

}  // namespace atom_mapping
