#pragma once

#include <ros/time.h>

namespace atom_mapping {

// Notices that time began anew, as when a bag is played again: the clock went back, or, with a clock that does not know
// of it, so did the clouds' stamps, and for good.
//
// Choice: a single cloud with an old stamp is a cloud out of order. Time went back when kClouds in a row, in order among
// themselves, lie more than kTolerance behind the newest in the map.
class TimeWatch {
 public:
  static constexpr int kClouds = 5;
  static constexpr double kTolerance = 1.0;  // s

  // Whether the clock went back since the last call.
  bool clockWentBack(const ros::Time& now);

  // Of each cloud as it comes in. `newest_mapped`: zero without any.
  bool stampsWentBack(const ros::Time& stamp, const ros::Time& newest_mapped);

 private:
  ros::Time now_;
  ros::Time last_behind_;
  int behind_ = 0;
};

}  // namespace atom_mapping
