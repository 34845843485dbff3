// How true the map of a whole drive is.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "atom_mapping/map/mapper.h"
#include "atom_mapping/query/occupancy_query.h"
#include "atom_mapping/sim/coverage.h"
#include "simulated.h"

namespace atom_map {

// A third of the rays from 0.5 to 25 m of a drive, as measured, with the true normals.
inline std::vector<ObservedRay> raysOf(const Drive& drive) {
  std::vector<ObservedRay> rays;
  for (std::size_t i = 0; i < drive.simulated.size(); ++i) {
    addRays(drive.simulated[i], drive.poses[i], ScanParameters(), 3, rays);
  }
  return rays;
}

// A map of a drive, judged and printed.
struct Result {
  Coverage coverage;
  std::uint64_t atoms = 0;
  std::uint64_t bytes = 0;
};

inline Result mapDrive(const Drive& drive, double radius) {
  MappingParameters parameters;
  parameters.radius = radius;
  Mapper mapper(parameters);
  ScanReport report;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) report = mapper.insertScan(drive.scans[i], drive.poses[i]);
  const Coverage coverage = mapper.read([&](const AtomMap& map) {
    return measureCoverage(
        raysOf(drive), radius, OccupancyQuery(map, parameters.gaussian_process),
        [&](const Eigen::Vector3d& point) { return drive.scene.signedDistance(point); }, 7);
  });
  std::printf("%-7s r %.2f: free %.4f, falsely occupied %.4f, unknown %.4f, surface %.4f, thin %.4f of %llu; ",
              drive.scene_name.c_str(), radius, coverage.free.value(), coverage.false_occupied.value(),
              coverage.unknown.value(), coverage.surface.value(), coverage.thin.value(),
              static_cast<unsigned long long>(coverage.thin.whole));
  std::printf("%llu atoms of %.1f bytes\n", static_cast<unsigned long long>(report.atoms),
              static_cast<double>(report.map_bytes) / static_cast<double>(report.atoms));
  return {coverage, report.atoms, report.map_bytes};
}

// Bounds from below, that of false_occupied from above.
inline void expectCoverage(const Coverage& coverage, double free, double false_occupied, double surface, double thin) {
  EXPECT_GE(coverage.free.value(), free);
  EXPECT_LE(coverage.false_occupied.value(), false_occupied);
  EXPECT_GE(coverage.surface.value(), surface);
  EXPECT_GE(coverage.thin.value(), thin);
  EXPECT_GT(coverage.thin.whole, 1000U);
}

}  // namespace atom_map
