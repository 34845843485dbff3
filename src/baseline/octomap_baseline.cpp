#include "atom_mapping/baseline/octomap_baseline.h"

#include <algorithm>
#include <cmath>

#include "atom_mapping/base/angles.h"

namespace atom_map {
namespace {

// Of a block of so many bytes: with its header, in steps of 16, four words at least.
constexpr std::size_t allocated(std::size_t size) {
  return std::max<std::size_t>(32, (size + sizeof(std::size_t) + 15) / 16 * 16);
}

}  // namespace

octomap::point3d toOctomap(const Eigen::Vector3d& point) {
  const Eigen::Vector3f p = point.cast<float>();
  return {p.x(), p.y(), p.z()};
}

double equalVolumeVoxel(double radius) {
  return radius * std::cbrt(4.0 * kPi / 3.0);
}

OctomapBaseline::OctomapBaseline(double resolution, bool prune) : tree_(resolution), prune_(prune) {}

std::size_t OctomapBaseline::insertScan(const std::vector<Eigen::Vector3f>& returns, const Pose& sensor,
                                        double max_range) {
  // OctoMap itself writes a warning to the terminal for each ray that leaves the tree.
  const auto is_inside = [this](const octomap::point3d& point) {
    octomap::OcTreeKey key;
    return tree_.coordToKeyChecked(point, key);
  };
  const octomap::point3d origin = toOctomap(sensor.translation());
  if (!is_inside(origin)) return 0;
  octomap::Pointcloud cloud;
  cloud.reserve(returns.size());
  for (const Eigen::Vector3f& point : returns) {
    const octomap::point3d end = toOctomap(sensor * point.cast<double>());
    if (is_inside(end)) cloud.push_back(end);
  }
  // OctoMap joins equal children in an eager update, whatever it is told; a lazy one is quicker.
  const bool lazy = !prune_;
  tree_.insertPointCloud(cloud, origin, max_range, lazy);
  return cloud.size();
}

std::optional<float> OctomapBaseline::logOdds(const Eigen::Vector3d& point) const {
  octomap::OcTreeKey key;
  if (!tree_.coordToKeyChecked(toOctomap(point), key)) return std::nullopt;
  const octomap::OcTreeNode* const node = tree_.search(key);
  if (node == nullptr) return std::nullopt;
  return node->getLogOdds();
}

Occupancy OctomapBaseline::classify(const Eigen::Vector3d& point) const {
  return atom_map::classify(logOdds(point));
}

std::size_t OctomapBaseline::bytes() const {
  constexpr std::size_t kChildren = 8 * sizeof(octomap::OcTreeNode*);  // of each inner node, in a block of their own
  const std::size_t inner_nodes = tree_.size() - tree_.getNumLeafNodes();
  return tree_.size() * allocated(sizeof(octomap::OcTreeNode)) + inner_nodes * allocated(kChildren);
}

}  // namespace atom_map
