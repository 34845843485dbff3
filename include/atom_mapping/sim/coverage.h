// How well a map agrees with the rays that made it: the coverages by which maps are judged, for any map that can be
// asked.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "atom_mapping/base/parameters.h"
#include "atom_mapping/base/types.h"
#include "atom_mapping/query/occupancy.h"
#include "atom_mapping/sim/simulate_scan.h"

namespace atom_map {

// One ray of a recording or a simulation, map frame.
struct ObservedRay {
  Eigen::Vector3d sensor;
  Eigen::Vector3d end;                    // the return, as measured
  std::optional<Eigen::Vector3d> normal;  // unit, towards free space; where the truth is known
  bool thin = false;                      // a return of a pole or trunk under 0.2 m of radius
};

// Whether a return lies in the range that maps use; what is not finite does not. `point` in the sensor's frame.
bool isInRange(const Eigen::Vector3f& point, const ScanParameters& parameters);

// Adds every `stride`-th of a recorded scan's returns, where it is in range. `sensor`: sensor frame to map frame.
void addRays(const LidarScan& scan, const Pose& sensor, const ScanParameters& parameters, std::size_t stride,
             std::vector<ObservedRay>& rays);

// The same of a simulated scan, with the true normals.
void addRays(const SimulatedScan& scan, const Pose& sensor, const ScanParameters& parameters, std::size_t stride,
             std::vector<ObservedRay>& rays);

// Of a point of the map frame.
using AskOccupancy = std::function<Occupancy(const Eigen::Vector3d&)>;
using AskTrueDistance = std::function<double(const Eigen::Vector3d&)>;

struct Share {
  std::uint64_t part = 0;
  std::uint64_t whole = 0;

  void count(bool hit) {
    part += hit ? 1 : 0;
    ++whole;
  }
  double value() const { return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole); }
};

// Shares of points: `free`, `false_occupied` and `unknown` of random points on the rays, two radii or more short of the
// return and, where the truth is known, a radius or more from any surface; `surface` of the points a radius beneath a
// return that are occupied; `thin` of the returns from thin things that are occupied.
struct Coverage {
  Share free;
  Share false_occupied;
  Share unknown;
  Share surface;
  Share thin;
};

// Draws one point on each ray, from the seed. `true_distance` may be empty.
Coverage measureCoverage(const std::vector<ObservedRay>& rays, double radius, const AskOccupancy& ask,
                         const AskTrueDistance& true_distance, std::uint64_t seed);

}  // namespace atom_map
