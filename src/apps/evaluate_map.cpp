// Judges the map of a simulated drive against the scene's exact truth, with OctoMap of equal unit volume beside it.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "atom_mapping/baseline/octomap_baseline.h"
#include "atom_mapping/map/mapper.h"
#include "atom_mapping/sim/coverage.h"
#include "atom_mapping/sim/make_scene.h"
#include "atom_mapping/sim/simulate_scan.h"

namespace {

using atom_map::AtomMap;
using atom_map::Coverage;
using atom_map::ObservedRay;
using Eigen::Vector3d;

constexpr std::uint64_t kSampleSeed = 7;  // of the points that the maps are asked for

struct Options {
  std::string scene = "hall";
  std::vector<double> radii{0.5};
  int scans = 40;
  double noise = 0.02;
  std::uint32_t seed = 1;
};

struct Drive {
  std::vector<atom_map::LidarScan> scans;
  std::vector<atom_map::Pose> poses;
  std::vector<ObservedRay> rays;
};

Drive simulate(const atom_map::Scene& scene, const Options& options, const atom_map::ScanParameters& parameters) {
  const atom_map::Trajectory trajectory = atom_map::makeTrajectory(options.scene);
  atom_map::LidarModel model;
  model.noise_sigma = options.noise;
  Drive drive;
  for (int i = 0; i < options.scans; ++i) {
    const double stamp = model.period * i;
    const atom_map::SimulatedScan scan = atom_map::simulateScan(scene, trajectory, stamp, model, options.seed);
    const atom_map::Pose pose = trajectory.sensorPose(stamp);
    drive.scans.push_back(atom_map::toLidarScan(scan));
    drive.poses.push_back(pose);
    for (const atom_map::SimulatedReturn& r : scan.returns) {
      if (!atom_map::isInRange(r.point, parameters)) continue;
      const Vector3d normal = pose.linear() * r.true_normal.cast<double>();
      drive.rays.push_back({pose.translation(), pose * r.point.cast<double>(), normal, atom_map::isThin(r.kind)});
    }
  }
  return drive;
}

void print(const char* map, double radius, const Coverage& c, std::size_t units) {
  std::printf("%-8s %6.2f %8.4f %15.4f %9.4f %9.4f %7.4f %10zu\n", map, radius, c.free.value(),
              c.false_occupied.value(), c.unknown.value(), c.surface.value(), c.thin.value(), units);
}

void judgeAtoms(const atom_map::Scene& scene, const Drive& drive, const atom_map::MappingParameters& parameters) {
  atom_map::Mapper mapper(parameters);
  for (std::size_t i = 0; i < drive.scans.size(); ++i) mapper.insertScan(drive.scans[i], drive.poses[i]);
  mapper.read([&](const AtomMap& map) {
    const auto ask = [&](const Vector3d& p) { return atom_map::classify(map, p); };
    const auto truth = [&](const Vector3d& p) { return scene.signedDistance(p); };
    print("atoms", parameters.radius, measureCoverage(drive.rays, parameters.radius, ask, truth, kSampleSeed),
          map.atoms().size());
  });
}

void judgeOctomap(const atom_map::Scene& scene, const Drive& drive, const atom_map::MappingParameters& parameters) {
  atom_map::OctomapBaseline map(atom_map::equalVolumeVoxel(parameters.radius));
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    std::vector<Eigen::Vector3f> returns;
    for (const Eigen::Vector3f& point : drive.scans[i].points) {
      if (atom_map::isInRange(point, parameters.scan)) returns.push_back(point);
    }
    map.insertScan(returns, drive.poses[i]);
  }
  const auto ask = [&](const Vector3d& p) { return map.classify(p); };
  const auto truth = [&](const Vector3d& p) { return scene.signedDistance(p); };
  print("octomap", parameters.radius, measureCoverage(drive.rays, parameters.radius, ask, truth, kSampleSeed),
        map.tree().getNumLeafNodes());
}

void run(const Options& options) {
  const atom_map::Scene scene = atom_map::makeScene(options.scene);
  atom_map::MappingParameters parameters;
  const Drive drive = simulate(scene, options, parameters.scan);
  std::printf("map      radius     free  falsely occupied   unknown   surface    thin      units\n");
  for (const double radius : options.radii) {
    parameters.radius = radius;
    judgeAtoms(scene, drive, parameters);
    judgeOctomap(scene, drive, parameters);
  }
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Judges the map of a simulated drive against the scene's exact truth, with OctoMap beside it.");
  app.add_option("--scene", options.scene, "hall, campus, cube, cube_rotated or sphere")->capture_default_str();
  app.add_option("--radius", options.radii, "of the atoms, metres; several may be given")->capture_default_str();
  app.add_option("--scans", options.scans)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--noise", options.noise, "standard deviation of a range, metres")->capture_default_str();
  app.add_option("--seed", options.seed, "of the noise")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    run(options);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "evaluate_map: %s\n", fault.what());
    return 2;
  }
  return 0;
}
