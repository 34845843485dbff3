#include "atom_mapping/baseline/octomap_baseline.h"

#include <cmath>

#include "atom_mapping/base/angles.h"

namespace atom_map {
namespace {

octomap::point3d toOctomap(const Eigen::Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

}  // namespace

double equalVolumeVoxel(double radius) {
  return radius * std::cbrt(4.0 * kPi / 3.0);
}

OctomapBaseline::OctomapBaseline(double resolution, bool prune) : tree_(resolution), prune_(prune) {}

void OctomapBaseline::insertScan(const std::vector<Eigen::Vector3f>& returns, const Pose& sensor) {
  octomap::Pointcloud cloud;
  cloud.reserve(returns.size());
  for (const Eigen::Vector3f& point : returns) cloud.push_back(toOctomap(sensor * point.cast<double>()));
  // Lazy: OctoMap joins equal children in an eager update, whatever it is told, and is slower.
  constexpr bool kLazy = true;
  tree_.insertPointCloud(cloud, toOctomap(sensor.translation()), -1.0, kLazy);
  if (!prune_) return;
  tree_.updateInnerOccupancy();
  tree_.prune();
}

Occupancy OctomapBaseline::classify(const Eigen::Vector3d& point) const {
  const octomap::OcTreeNode* node = tree_.search(toOctomap(point));
  if (node == nullptr) return Occupancy::kUnknown;
  return tree_.isNodeOccupied(node) ? Occupancy::kOccupied : Occupancy::kFree;
}

}  // namespace atom_map
