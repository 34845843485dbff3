#pragma once

#include <sensor_msgs/PointCloud2.h>

#include <stdexcept>

#include "atom_mapping/base/types.h"

namespace atom_mapping {

// A cloud whose fields, sizes and data contradict one another; what() gives the value and what is expected.
class MalformedCloud : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A cloud's points row by row as they are, NaN and infinities too. Any layout with float32 x, y and z will do, of
// either byte order, and no points at all. With `infer_no_returns` the directions of the +Inf points of an organized
// cloud as well (no_returns.h). Throws MalformedCloud. Never allocates more than the size of the cloud's data calls
// for.
atom_map::LidarScan toLidarScan(const sensor_msgs::PointCloud2& cloud, bool infer_no_returns = false);

}  // namespace atom_mapping
