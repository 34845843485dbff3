// Drives a simulated VLP-16 through a scene with exact ground truth and writes a bag of what its drivers would publish.
#include <rosbag/bag.h>
#include <tf2_msgs/TFMessage.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>

#include "atom_mapping/apps/finite_range.h"
#include "atom_mapping/apps/run_program.h"
#include "atom_mapping/base/angles.h"
#include "atom_mapping/ros/simulated_messages.h"
#include "atom_mapping/sim/make_scene.h"
#include "atom_mapping/sim/simulate_scan.h"
#include "atom_mapping/sim/trajectory.h"

namespace {

using atom_map::kDegree;
using atom_map::LidarModel;
using atom_map::Scene;
using atom_map::Trajectory;
using atom_mapping::finiteRange;

constexpr std::uint32_t kStartTime = 1500000000;  // s, stamp of the first scan
constexpr int kTransformPeriod = 20;              // ms
constexpr int kMargin = 200;                      // ms of transforms before the first and after the last scan

struct Options {
  std::string scene;
  int scans = 0;
  std::string out;
  std::uint32_t seed = 1;
  std::optional<double> mount_roll;   // deg
  std::optional<double> mount_pitch;  // deg
  bool organized = false;
  LidarModel lidar;
};

// Of a moment in milliseconds since the first scan.
ros::Time stampAt(int milliseconds) {
  return ros::Time(kStartTime, 0) + ros::Duration().fromNSec(std::int64_t{1000000} * milliseconds);
}

std_msgs::Header makeHeader(const std::string& frame, int milliseconds) {
  std_msgs::Header header;
  header.frame_id = frame;
  header.stamp = stampAt(milliseconds);
  return header;
}

tf2_msgs::TFMessage makeTransforms(const atom_map::Pose& pose, const std_msgs::Header& header,
                                   const std::string& child) {
  tf2_msgs::TFMessage message;
  message.transforms.push_back(atom_map::toTransformStamped(pose, header, child));
  return message;
}

// rosbag play latches a topic only if its connection header says so.
boost::shared_ptr<ros::M_string> makeLatchedHeader() {
  auto header = boost::make_shared<ros::M_string>();
  (*header)["type"] = ros::message_traits::datatype<tf2_msgs::TFMessage>();
  (*header)["md5sum"] = ros::message_traits::md5sum<tf2_msgs::TFMessage>();
  (*header)["message_definition"] = ros::message_traits::definition<tf2_msgs::TFMessage>();
  (*header)["callerid"] = "/simulate_bag";
  (*header)["latching"] = "1";
  return header;
}

Trajectory makeDrive(const Options& options) {
  Trajectory trajectory = atom_map::makeTrajectory(options.scene);
  const Eigen::Matrix3d turn = trajectory.mount.linear();
  const double roll = options.mount_roll ? *options.mount_roll * kDegree : std::atan2(turn(2, 1), turn(2, 2));
  const double pitch = options.mount_pitch ? *options.mount_pitch * kDegree : std::asin(-turn(2, 0));
  trajectory.mount.linear() = atom_map::mountRotation(roll, pitch).toRotationMatrix();
  return trajectory;
}

sensor_msgs::PointCloud2 scanAt(const Options& options, const Scene& scene, const Trajectory& drive, int milliseconds) {
  const auto scan = atom_map::simulateScan(scene, drive, 1e-3 * milliseconds, options.lidar, options.seed);
  const std_msgs::Header header = makeHeader("velodyne", milliseconds);
  return options.organized ? atom_map::toOrganizedPointCloud2(scan, options.lidar, header)
                           : atom_map::toPointCloud2(scan, header);
}

void writeDrive(const Options& options, rosbag::Bag& bag) {
  const Scene scene = atom_map::makeScene(options.scene);
  const Trajectory drive = makeDrive(options);
  const int scan_period = static_cast<int>(std::lround(1e3 * options.lidar.period));
  const int last_scan = scan_period * (options.scans - 1);
  bag.write("/tf_static", stampAt(-kMargin), makeTransforms(drive.mount, makeHeader("base_link", -kMargin), "velodyne"),
            makeLatchedHeader());
  for (int now = -kMargin; now <= last_scan + kMargin; now += kTransformPeriod) {
    const auto transforms = makeTransforms(drive.base_pose(1e-3 * now), makeHeader("map", now), "base_link");
    bag.write("/tf", stampAt(now), transforms);
    const bool scan_is_due = now >= 0 && now <= last_scan && now % scan_period == 0;
    if (scan_is_due) bag.write("/velodyne_points", stampAt(now), scanAt(options, scene, drive, now));
  }
}

void addOptions(CLI::App& app, Options& options) {
  LidarModel& lidar = options.lidar;
  app.add_option("--scene", options.scene, "World to drive through")
      ->required()
      ->check(CLI::IsMember(atom_map::sceneNames()));
  app.add_option("--scans", options.scans, "Scans to take, 10 a second")->required()->check(CLI::Range(1, 1000000));
  app.add_option("--out", options.out, "Bag to write; an existing file is replaced")->required();
  app.add_option("--noise", lidar.noise_sigma, "Standard deviation of a range, metres (0.02)")
      ->check(finiteRange(0.0, 10.0));
  app.add_option("--seed", options.seed, "Of the noise and the lost returns (1)")->check(CLI::Range(0.0, 4294967295.0));
  app.add_option("--dropout", lidar.dropout, "Probability that a return is lost (0)")->check(finiteRange(0.0, 1.0));
  app.add_option("--mount-roll", options.mount_roll, "Degrees (the scene's)")->check(finiteRange(-180.0, 180.0));
  app.add_option("--mount-pitch", options.mount_pitch, "Degrees, nose down (the scene's)")
      ->check(finiteRange(-90.0, 90.0));
  app.add_flag("--motion-distortion", lidar.motion_distortion, "Each firing leaves from the pose of its own moment");
  app.add_flag("--organized", options.organized, "Clouds of 16 rows x 1800 columns, +Inf where nothing came back");
}

void run(const Options& options) {
  try {
    rosbag::Bag bag(options.out, rosbag::bagmode::Write);
    writeDrive(options, bag);
    bag.close();
  } catch (const std::exception& fault) {
    throw std::runtime_error("cannot write " + options.out + ": " + fault.what());
  }
  std::printf("%s: %d scans of %s\n", options.out.c_str(), options.scans, options.scene.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Writes a bag of a simulated VLP-16 (/velodyne_points, /tf, /tf_static) driven through a scene.",
               "simulate_bag");
  Options options;
  addOptions(app, options);
  return atom_mapping::runProgram(app, argc, argv, [&] { run(options); });
}
