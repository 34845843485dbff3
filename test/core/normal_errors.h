// Estimated normals beside the true ones.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "atom_mapping/scan/normals.h"
#include "simulated.h"

namespace atom_map {

struct Estimate {
  SurfacePoint point;
  const SimulatedReturn* truth;
  double error;  // deg
};

// Of all returns from 0.5 m to 25 m.
inline std::vector<Estimate> estimate(const SimulatedScan& scan, NormalReport& report, double range_noise = 0.02) {
  ScanParameters parameters;
  parameters.thinning = 0.0;
  parameters.shared_normals = 0.0;
  parameters.range_noise = range_noise;
  Random random(1);
  const FilteredScan filtered = filterScan(toLidarScan(scan), 0.5, parameters, random);
  std::vector<KnownPlane> known;
  const std::vector<SurfacePoint> surface =
      estimateSurface(filtered, Eigen::Isometry3f::Identity(), 0.5, parameters, known, report);
  EXPECT_EQ(filtered.points.size(), scan.returns.size()) << "their indices should be the same";
  EXPECT_EQ(surface.size(), filtered.rays.size());
  std::vector<Estimate> estimates;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const SimulatedReturn& truth = scan.returns.at(filtered.rays[i]);
    const Eigen::Vector3d normal = surface[i].normal.cast<double>();
    const Eigen::Vector3d true_normal = truth.true_normal.cast<double>();
    const double error = std::atan2(normal.cross(true_normal).norm(), normal.dot(true_normal));
    estimates.push_back({surface[i], &truth, error * 180.0 / M_PI});
  }
  return estimates;
}

struct Errors {
  std::vector<double> all;

  double quantile(double share) {
    const auto place = all.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(all.size() - 1));
    std::nth_element(all.begin(), place, all.end());
    return *place;
  }
  double shareOver(double limit) const {
    const auto over = std::count_if(all.begin(), all.end(), [&](double error) { return error > limit; });
    return static_cast<double>(over) / static_cast<double>(all.size());
  }
};

}  // namespace atom_map
