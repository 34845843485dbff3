#include "atom_mapping/ros/insert_bag.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "atom_mapping/ros/bag_progress.h"
#include "atom_mapping/ros/time_watch.h"

namespace atom_mapping {

void insertBag(BagReader& bag, std::optional<std::size_t> scans, CloudServer& server,
               const std::function<void(const ScanOutcome&)>& each) {
  bag.expectUsable();
  const std::size_t total = std::min(scans.value_or(bag.clouds()), bag.clouds());
  BagProgress progress(total, std::cerr, isatty(STDERR_FILENO) == 1);
  TimeWatch time_watch;
  ros::Time newest;  // of the clouds since time began
  for (std::size_t i = 0; i < total; ++i) {
    const auto cloud = bag.next();
    if (!cloud) return;
    const bool is_any_mapped = !server.newest().isZero();
    if (time_watch.stampsWentBack(cloud->header.stamp, is_any_mapped ? server.newest() : newest)) {
      bag.restartTime();
      server.restartTime();
      newest = ros::Time();
    }
    newest = std::max(newest, cloud->header.stamp);
    each(server.insert(*cloud, bag.transforms()));
    progress.step();
  }
}

}  // namespace atom_mapping
