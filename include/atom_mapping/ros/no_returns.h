#pragma once

#include <Eigen/Core>
#include <vector>

namespace atom_mapping {

// Unit directions of the rays of an organized scan that came back without an echo. Such a point is +Inf (REP 117),
// which tells nothing of where the ray went; but the rows of a spinning lidar are rings, each of one elevation, and the
// columns firings, each of one azimuth. `points` row by row, sensor frame, z along the axis of rotation.
//
// Choice: a ring's elevation is the median of its returns', a firing's azimuth the median of its returns' or, without
// any, lies between its neighbours' where the sensor turned evenly. Rows and columns whose angles scatter (a camera, a
// staggered layout) and all that cannot be told so are left out: a ray that is not freed costs less than a false one.
std::vector<Eigen::Vector3f> inferNoReturns(const std::vector<Eigen::Vector3f>& points, std::size_t columns);

}  // namespace atom_mapping
