#include "atom_mapping/ros/time_watch.h"

namespace atom_mapping {

bool TimeWatch::clockWentBack(const ros::Time& now) {
  const bool went_back = now < now_;
  now_ = now;
  return went_back;
}

bool TimeWatch::stampsWentBack(const ros::Time& stamp, const ros::Time& newest_mapped) {
  const bool is_behind = stamp.toSec() + kTolerance < newest_mapped.toSec();
  const bool is_next = behind_ == 0 || stamp > last_behind_;
  behind_ = is_behind ? (is_next ? behind_ + 1 : 1) : 0;
  last_behind_ = stamp;
  if (behind_ < kClouds) return false;
  behind_ = 0;
  return true;
}

}  // namespace atom_mapping
