// Vocabulary of the core. Lengths are metres, angles radians, frames right-handed with z up (REP 103).
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace atom_map {

// One revolution of a lidar, in the sensor's frame at the scan's stamp.
struct LidarScan {
  std::vector<Eigen::Vector3f> points;      // returns; may hold NaN and infinities (REP 117), which the filter drops
  std::vector<Eigen::Vector3f> no_returns;  // unit directions of rays that came back without an echo
};

// Sensor frame to map frame. Double, because a map frame may lie 100 km from its origin.
using Pose = Eigen::Isometry3d;

// A return and what the scan tells of the surface that it lies on.
struct SurfacePoint {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;  // unit, turned towards the sensor
  float half_width;        // m, of a thing that stands free of its background left and right; infinite for others
};

// What a candidate may do that overlaps atoms of the map: see OccupancyMerge.
enum class Aside : std::uint8_t {
  kNever,
  kOfOne,  // what fills space: stand aside of a lone atom
  kOfAll,  // of a thing narrower than the space between atoms may be: of any number
};

// An atom proposed by one scan in occupancy mode.
struct Candidate {
  Eigen::Vector3f center;
  float value;        // log-odds of occupancy to add (paper, Eq. 3)
  float hold = 0.0F;  // m from the centre within which the scan's free candidates lower no atom
  Aside aside = Aside::kNever;
};

}  // namespace atom_map
