#include <cmath>

#include "atom_mapping/baseline/octomap_baseline.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;
using octomap::OcTreeKey;

Vector3d toEigen(const octomap::point3d& point) {
  return Eigen::Vector3f(point.x(), point.y(), point.z()).cast<double>();
}

bool touches(const Vector3d& center, double radius, const octomap::point3d& voxel, double side) {
  const Vector3d beyond = ((center - toEigen(voxel)).cwiseAbs().array() - 0.5 * side).cwiseMax(0.0);
  return beyond.squaredNorm() <= radius * radius;
}

// Of the voxel around a point, or the nearest that the tree has.
OcTreeKey nearestKey(const octomap::OcTree& tree, const Vector3d& point) {
  constexpr double kLast = 65535.0;
  OcTreeKey key;
  for (unsigned i = 0; i < 3; ++i) {
    const double cell = std::floor(point[i] / tree.getResolution()) + 32768.0;
    key[i] = static_cast<octomap::key_type>(std::clamp(cell, 0.0, kLast));
  }
  return key;
}

}  // namespace

bool OctomapBaseline::collides(const Vector3d& center, double radius, bool unknown_is_free) const {
  return touchesOccupied(center, radius) || (!unknown_is_free && touchesUnknown(center, radius));
}

bool OctomapBaseline::touchesOccupied(const Vector3d& center, double radius) const {
  const OcTreeKey first = nearestKey(tree_, center - Vector3d::Constant(radius));
  const OcTreeKey last = nearestKey(tree_, center + Vector3d::Constant(radius));
  const auto end = tree_.end_leafs_bbx();
  for (auto leaf = tree_.begin_leafs_bbx(first, last); leaf != end; ++leaf) {
    if (tree_.isNodeOccupied(*leaf) && touches(center, radius, leaf.getCoordinate(), leaf.getSize())) return true;
  }
  return false;
}

bool OctomapBaseline::touchesUnknown(const Vector3d& center, double radius) const {
  OcTreeKey key;
  if (!tree_.coordToKeyChecked(toOctomap(center), key)) return true;
  const OcTreeKey first = nearestKey(tree_, center - Vector3d::Constant(radius));
  const OcTreeKey last = nearestKey(tree_, center + Vector3d::Constant(radius));
  for (std::uint32_t z = first[2]; z <= last[2]; ++z) {
    for (std::uint32_t y = first[1]; y <= last[1]; ++y) {
      for (std::uint32_t x = first[0]; x <= last[0]; ++x) {
        key = OcTreeKey(static_cast<octomap::key_type>(x), static_cast<octomap::key_type>(y),
                        static_cast<octomap::key_type>(z));
        if (touches(center, radius, tree_.keyToCoord(key), tree_.getResolution()) && tree_.search(key) == nullptr) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace atom_map
