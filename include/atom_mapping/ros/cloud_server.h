#pragma once

#include <ros/time.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2/buffer_core.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "atom_mapping/ScanReport.h"
#include "atom_mapping/base/types.h"
#include "atom_mapping/map/scan_report.h"
#include "atom_mapping/ros/scan_counts.h"

namespace atom_mapping {

// What became of one cloud.
struct ScanOutcome {
  std::optional<Drop> drop;  // empty: it was mapped
  std::string message;       // of a drop: what was wrong with the cloud, for a person
  ScanReport report;         // of a mapped one
};

// Clouds and transforms in, scans with their poses out to a map, whichever it is: what the nodes and the programs that
// read bags share; they differ in the map and in who feeds it.
// Thread safety: any member may be called at any time from any thread, but clouds come from one thread at a time.
class CloudServer {
 public:
  // `infer_no_returns`: as toLidarScan.
  CloudServer(const std::string& map_frame, bool infer_no_returns);
  virtual ~CloudServer() = default;
  CloudServer(const CloudServer&) = delete;
  CloudServer& operator=(const CloudServer&) = delete;

  // Maps a cloud from where tf says that its frame was at its stamp; does not wait for a transform. Never throws and
  // never maps from a doubtful pose: what cannot be used is dropped, counted, and leaves the map as it was.
  ScanOutcome insert(const sensor_msgs::PointCloud2& cloud, const tf2::BufferCore& transforms);

  // Counts a cloud that was dropped before it came here. `message`: for a person.
  ScanOutcome drop(Drop cause, const std::string& message);

  // Time began anew: the next cloud may be older than those in the map.
  void restartTime();

  ScanCounts counts() const;
  // Grows whenever the map changed.
  std::uint64_t revision() const;

  // Stamp of the newest cloud in the map; zero before the first.
  ros::Time newest() const;

  // Where the sensor was at the newest cloud, sensor to map frame; nothing before the first.
  std::optional<atom_map::Pose> sensorPose() const;

  const std::string& mapFrame() const { return map_frame_; }

 protected:
  // The map changed otherwise than by a cloud.
  void noteChange();

 private:
  // Merges a scan into the map, as Mapper::insertScan.
  virtual atom_map::ScanReport insertScan(const atom_map::LidarScan& scan, const atom_map::Pose& sensor) = 0;

  std::uint64_t checkOrder(const ros::Time& stamp) const;
  void noteMapped(const ros::Time& stamp, std::uint64_t era, const atom_map::Pose& sensor, bool is_empty);

  std::string map_frame_;  // without a leading slash, which tf2 refuses
  bool infer_no_returns_;
  mutable std::mutex mutex_;  // of what follows
  ScanCounts counts_;
  std::uint64_t revision_ = 0;
  std::uint64_t era_ = 0;  // how often time began anew
  ros::Time newest_;
  std::optional<atom_map::Pose> sensor_pose_;
};

}  // namespace atom_mapping
