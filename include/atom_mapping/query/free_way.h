#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "atom_mapping/map/atom_map.h"

namespace atom_map {

// How far a ray is free by what its atoms store, without asking for the occupancy between them.
class FreeWay {
 public:
  // The map must outlive this. As castRay has them: origin in the map's local frame, unit direction.
  FreeWay(const AtomMap& map, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction);

  // The end of what is certainly free from a point of the ray that is; that point itself where nothing is certain. `from`
  // must not decrease from call to call. In metres from the origin; `range`, at which it ends, may be infinite.
  double end(double from, double range);

 private:
  // The ray is looked at in parts of so many cells, a bit each, whose claims need no sorting.
  static constexpr int kCells = 64;

  void look(double from, double range);
  void claim(ConstAtomRef atom);

  const AtomMap& map_;
  Eigen::Vector3f origin_;
  Eigen::Vector3f direction_;
  double cell_;               // m
  double begin_ = 0.0;        // m, of the part
  double end_ = 0.0;          // m, of the part
  std::uint64_t free_ = 0;    // cells that lie within what one atom says is free
  std::uint64_t unsure_ = 0;  // cells that another kind of atom reaches into
};

}  // namespace atom_map
