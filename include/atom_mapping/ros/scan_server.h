#pragma once

#include <ros/time.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2/buffer_core.h>

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "atom_mapping/ScanReport.h"
#include "atom_mapping/map/mapper.h"
#include "atom_mapping/ros/scan_counts.h"

namespace atom_mapping {

// What became of one cloud.
struct ScanOutcome {
  std::optional<Drop> drop;  // empty: it was mapped
  std::string message;       // of a drop: what was wrong with the cloud, for a person
  ScanReport report;         // of a mapped one
};

// Clouds and transforms in, map out: what the node and the offline tool share; they differ in who feeds it.
// Thread safety: any member may be called at any time from any thread, but clouds come from one thread at a time.
class ScanServer {
 public:
  // Throws std::invalid_argument that names every parameter out of its range.
  explicit ScanServer(const atom_map::MappingParameters& parameters);

  // Maps a cloud from where tf says that its frame was at its stamp; does not wait for a transform. Never throws and
  // never maps from a doubtful pose: what cannot be used is dropped, counted, and leaves the map as it was.
  ScanOutcome insert(const sensor_msgs::PointCloud2& cloud, const tf2::BufferCore& transforms);

  // Counts a cloud that was dropped before it came here. `message`: for a person.
  ScanOutcome drop(Drop cause, const std::string& message);

  // Time began anew: the next cloud may be older than those in the map.
  void restartTime();

  // As AtomMap::clearRegion and Mapper::reset. Reset also restarts time; counts go on.
  std::size_t clearRegion(const Eigen::AlignedBox3d& box);
  void reset();
  // As Mapper::replace. Also restarts time.
  void replace(atom_map::AtomMap map, std::uint64_t scans);

  ScanCounts counts() const;
  // Grows whenever the map changed.
  std::uint64_t revision() const;

  // Stamp of the newest cloud in the map; zero before the first.
  ros::Time newest() const;

  // Where the sensor was at the newest cloud, sensor to map frame; nothing before the first.
  std::optional<atom_map::Pose> sensorPose() const;

  // As Mapper::read, save that readers come one at a time: such as overlap could hold the merge up for ever, since a
  // std::shared_mutex lets them in first.
  template <class F>
  auto read(F&& f) const {
    const std::lock_guard lock(reading_);
    return mapper_.read(std::forward<F>(f));
  }

  const atom_map::Mapper& mapper() const { return mapper_; }
  const atom_map::MappingParameters& parameters() const { return mapper_.parameters(); }
  const std::string& mapFrame() const { return map_frame_; }

 private:
  std::uint64_t checkOrder(const ros::Time& stamp) const;
  void noteMapped(const ros::Time& stamp, std::uint64_t era, const atom_map::Pose& sensor, bool is_empty);
  void noteChange();

  atom_map::Mapper mapper_;
  std::string map_frame_;  // without a leading slash, which tf2 refuses
  mutable std::mutex reading_;
  mutable std::mutex mutex_;  // of what follows
  ScanCounts counts_;
  std::uint64_t revision_ = 0;
  std::uint64_t era_ = 0;  // how often time began anew
  ros::Time newest_;
  std::optional<atom_map::Pose> sensor_pose_;
};

}  // namespace atom_mapping
