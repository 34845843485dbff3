// A spinning lidar in a scene, with the truth beside every return.
#pragma once

#include <cstdint>
#include <vector>

#include "atom_mapping/base/types.h"
#include "atom_mapping/sim/scene.h"
#include "atom_mapping/sim/trajectory.h"

namespace atom_map {

// Velodyne VLP-16 at 10 Hz, the rings evenly spaced.
struct LidarModel {
  int rings = 16;
  double lowest = -15.0;           // deg, elevation of ring 0
  double ring_spacing = 2.0;       // deg
  int firings = 1800;              // a revolution, each of all rings at one azimuth
  double period = 0.1;             // s a revolution
  double min_range = 0.4;          // m, nearer surfaces return nothing
  double max_range = 100.0;        // m
  double noise_sigma = 0.02;       // m, Gaussian, along the ray
  double dropout = 0.0;            // probability that a return is lost
  bool motion_distortion = false;  // false: every ray leaves from the pose at the stamp, and every time is 0
};

struct SimulatedReturn {
  Eigen::Vector3f point;        // with noise; sensor frame of the moment of firing, as a driver publishes it
  Eigen::Vector3f true_point;   // without noise
  Eigen::Vector3f true_normal;  // unit, towards free space; same frame
  SurfaceKind kind;
  float intensity;       // 0..255
  float time;            // s after the stamp: in (-period, 0], as the driver stamps the end of a revolution
  std::uint16_t ring;    // 0 is the lowest
  std::uint16_t firing;  // 0.. in the order of time, clockwise from behind the sensor
};

// A ray that came back without an echo: nothing in range, too near, or lost by dropout.
struct SimulatedNoReturn {
  Eigen::Vector3f direction;  // unit, sensor frame of the moment of firing
  float time;                 // as of a return
  std::uint16_t ring;
  std::uint16_t firing;
};

// Firing by firing, within a firing in the order that a VLP-16 fires its lasers.
struct SimulatedScan {
  std::vector<SimulatedReturn> returns;
  std::vector<SimulatedNoReturn> no_returns;
};

// The revolution that ends at `stamp`, seconds since the start of the drive. Noise and dropout depend on the seed and
// the stamp only, so one seed serves a whole drive.
SimulatedScan simulateScan(const Scene& scene, const Trajectory& trajectory, double stamp, const LidarModel& model,
                           std::uint64_t seed);

// What a mapper sees of it.
LidarScan toLidarScan(const SimulatedScan& scan);

}  // namespace atom_map
