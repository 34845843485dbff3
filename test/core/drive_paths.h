// The figures of planned paths: through the map of a drive, held against the scene's truth.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "atom_mapping/map/mapper.h"
#include "atom_mapping/planning/plan_path.h"
#include "draw.h"
#include "simulated.h"
#include "truth_grid.h"

namespace atom_map {

constexpr double kAtom = 0.25;   // m, radius
constexpr double kRobot = 0.3;   // m, radius
constexpr double kCell = 0.25;   // m, of the true grid
constexpr double kRange = 25.0;  // m

struct PathFigures {
  int pairs = 0;
  int found = 0;
  double nearest = 1e9;              // m, of any point of a path to a true surface
  double deviation = 0.0;            // m, mean of | |true sdf| - q | along the paths
  std::vector<double> length_ratio;  // sorted, to the grid's shortest
  std::vector<double> seconds;       // sorted, of CPU
};

inline double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

inline double share(const std::vector<double>& sorted, double part) {
  return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

class PathWorld {
 public:
  explicit PathWorld(const std::string& scene_name, Mode mode = Mode::kOccupancy)
      : drive_(makeDrive(scene_name, 40)),
        mapper_(parameters(mode)),
        rays_(rays()),
        grid_(drive_.scene, rays_, kCell, kRobot) {
    for (std::size_t i = 0; i < drive_.scans.size(); ++i) mapper_.insertScan(drive_.scans[i], drive_.poses[i]);
  }

  // Plans between random points on the rays that the grid joins.
  PathFigures plan(int pairs, double surface_weight, double farthest_surface = 1e9) const {
    PathFigures figures;
    Random random(1);
    while (figures.pairs < pairs) {
      PathRequest request{drawPlace(random, farthest_surface), drawPlace(random, farthest_surface), {}};
      request.preference = {static_cast<float>(kRobot), 1.0F, static_cast<float>(surface_weight)};
      const auto shortest = grid_.shortest(request.start, request.goal);
      if (!shortest) continue;
      ++figures.pairs;
      const double begin = cpuSeconds();
      const PlannedPath path =
          planPath([&](const auto& use) { mapper_.read(use); }, request, GaussianProcessParameters());
      figures.seconds.push_back(cpuSeconds() - begin);
      if (path.outcome == PathOutcome::kFound) judge(path, *shortest, figures);
    }
    std::sort(figures.length_ratio.begin(), figures.length_ratio.end());
    std::sort(figures.seconds.begin(), figures.seconds.end());
    print(figures, surface_weight);
    return figures;
  }

 private:
  static MappingParameters parameters(Mode mode) {
    MappingParameters parameters;
    parameters.radius = kAtom;
    parameters.mode = mode;
    return parameters;
  }

  std::vector<ObservedRay> rays() const {
    std::vector<ObservedRay> rays;
    for (std::size_t i = 0; i < drive_.scans.size(); ++i) {
      for (const Eigen::Vector3f& point : drive_.scans[i].points) {
        const auto range = static_cast<double>(point.norm());
        if (range < 0.5 || range > kRange) continue;
        rays.push_back({drive_.poses[i].translation(), drive_.poses[i] * point.cast<double>(), {}});
      }
    }
    return rays;
  }

  Eigen::Vector3d drawPlace(Random& random, double farthest_surface) const {
    for (;;) {
      const ObservedRay& ray = rays_[drawIndex(random, rays_.size())];
      const Eigen::Vector3d place = ray.sensor + static_cast<double>(random.uniform()) * (ray.end - ray.sensor);
      const double distance = drive_.scene.signedDistance(place);
      if (distance >= kRobot && distance <= farthest_surface && grid_.isOpen(place)) return place;
    }
  }

  void judge(const PlannedPath& path, double shortest, PathFigures& figures) const {
    ++figures.found;
    double deviation = 0.0;
    int samples = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      const Eigen::Vector3d way = path.points[i] - path.points[i - 1];
      const int steps = static_cast<int>(way.norm() / 0.02) + 1;
      for (int k = 0; k < steps; ++k) {
        const double distance = drive_.scene.signedDistance(path.points[i - 1] + static_cast<double>(k) / steps * way);
        figures.nearest = std::min(figures.nearest, distance);
        deviation += std::abs(std::abs(distance) - 1.0);
        ++samples;
      }
    }
    figures.deviation += (deviation / std::max(samples, 1) - figures.deviation) / figures.found;
    if (shortest > 2.0) figures.length_ratio.push_back(path.length / shortest);  // shorter ones tell of the cells only
  }

  void print(const PathFigures& figures, double surface_weight) const {
    std::printf(
        "%-6s mu %4.1f: %d of %d found, nearest to a surface %.3f m, length to grid's median %.3f, 99 %% %.3f, most "
        "%.3f, mean | |sdf| - q | %.3f m, CPU 95 %% %.3f s, most %.3f s\n",
        drive_.scene_name.c_str(), surface_weight, figures.found, figures.pairs, figures.nearest,
        share(figures.length_ratio, 0.5), share(figures.length_ratio, 0.99), share(figures.length_ratio, 1.0),
        figures.deviation, share(figures.seconds, 0.95), share(figures.seconds, 1.0));
  }

  Drive drive_;
  Mapper mapper_;
  std::vector<ObservedRay> rays_;
  TruthGrid grid_;
};

inline void expectGoodPaths(const PathFigures& figures) {
  EXPECT_GE(figures.found, figures.pairs * 95 / 100);
  EXPECT_GE(figures.nearest, kRobot - 0.5 * kAtom);
  EXPECT_LE(share(figures.length_ratio, 1.0), 1.15);
  EXPECT_LE(share(figures.seconds, 0.95), 0.5);
}

}  // namespace atom_map
