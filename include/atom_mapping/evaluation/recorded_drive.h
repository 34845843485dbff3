#pragma once

#include <cstdint>
#include <vector>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/sim/coverage.h"
#include "atom_mapping/sim/simulate_scan.h"

namespace atom_map {

// A simulated drive, and its rays with their true normals.
struct RecordedDrive {
  std::vector<LidarScan> scans;
  std::vector<Pose> poses;  // sensor frame to map frame
  std::vector<ObservedRay> rays;
};

// Of the rays every `stride`-th of a scan that is in the range of the parameters.
RecordedDrive recordDrive(const Scene& scene, const Trajectory& trajectory, const LidarModel& model, int scans,
                          std::uint64_t seed, const ScanParameters& parameters, std::size_t stride = 1);

// Ground that rises along x by some degrees, and a robot that climbs it at 1 m/s, its lidar 1.6 m above and level with it
// (paper, Fig. 9).
Scene makeSlope(double degrees);
Trajectory makeClimb(double degrees);

// Share of the returns from the ground that a map keeps: it calls occupied the return itself, or a point half a radius or
// a radius beneath. `rays` with their normals.
Share measureGroundKept(const std::vector<ObservedRay>& rays, double radius, const AskOccupancy& ask);

}  // namespace atom_map
