#include "atom_mapping/baseline/export_octree.h"

#include <octomap/OcTree.h>

#include <cmath>
#include <ostream>
#include <stdexcept>

#include "atom_mapping/baseline/octomap_baseline.h"
#include "atom_mapping/io/write_file.h"
#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

// Of an atom's volume, to five digits: the file keeps six, and what it rounds moves voxels that lie kilometres away.
double voxelSide(double radius) {
  const double side = equalVolumeVoxel(radius);
  const double scale = std::pow(10.0, 4.0 - std::floor(std::log10(side)));
  return std::round(side * scale) / scale;
}

octomap::OcTreeKey keyOf(const octomap::OcTree& tree, const Eigen::Vector3d& p) {
  octomap::OcTreeKey key;
  if (tree.coordToKeyChecked(p.x(), p.y(), p.z(), key)) return key;
  throw std::runtime_error("the map reaches beyond the 32768 voxels to each side that OctoMap has");
}

// Gives a voxel that was not looked at before what the map says of its centre.
void fillVoxel(const AtomMap& map, const octomap::OcTreeKey& key, octomap::KeySet& seen, octomap::OcTree& tree) {
  if (!seen.insert(key).second) return;
  const Eigen::Vector3d center(tree.keyToCoord(key[0]), tree.keyToCoord(key[1]), tree.keyToCoord(key[2]));
  const Occupancy occupancy = classify(interpolate(map, map.toLocal(center)));
  if (occupancy == Occupancy::kUnknown) return;
  constexpr bool kLazy = true;  // inner nodes follow at the end
  const bool is_occupied = occupancy == Occupancy::kOccupied;
  tree.setNodeValue(key, is_occupied ? tree.getClampingThresMaxLog() : tree.getClampingThresMinLog(), kLazy);
}

// All that is known lies within two radii of an atom's centre.
void fillAround(const AtomMap& map, const Eigen::Vector3d& center, octomap::KeySet& seen, octomap::OcTree& tree) {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(2.0 * static_cast<double>(map.radius()));
  const octomap::OcTreeKey low = keyOf(tree, center - reach);
  const octomap::OcTreeKey high = keyOf(tree, center + reach);
  for (unsigned x = low[0]; x <= high[0]; ++x) {
    for (unsigned y = low[1]; y <= high[1]; ++y) {
      for (unsigned z = low[2]; z <= high[2]; ++z) {
        const auto key = [](unsigned k) { return static_cast<octomap::key_type>(k); };
        fillVoxel(map, {key(x), key(y), key(z)}, seen, tree);
      }
    }
  }
}

}  // namespace

void exportOctree(const AtomMap& map, const std::string& file) {
  checkWritable(file);
  octomap::OcTree tree(voxelSide(static_cast<double>(map.radius())));
  octomap::KeySet seen;
  map.atoms().forEach([&](const ConstAtomRef& atom) { fillAround(map, map.toMap(atom.center()), seen, tree); });
  tree.updateInnerOccupancy();
  tree.prune();
  writeFile(file, [&](std::ostream& out) {
    if (!tree.writeBinary(out)) out.setstate(std::ios::failbit);
  });
}

}  // namespace atom_map
