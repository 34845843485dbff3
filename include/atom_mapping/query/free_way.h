#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "atom_mapping/map/atom_map.h"

namespace atom_map {

// How far a ray is free by what its atoms store, without asking for the occupancy between them.
class FreeWay {
 public:
  // The map must outlive this. As castRay has them: origin in the map's local frame, unit direction.
  FreeWay(const AtomMap& map, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction);

  // The end of what is certainly free from a point of the ray on, if that is free; the point itself where nothing is certain.
  // `from` must not decrease from call to call. In metres from the origin; `range`, at which it ends, may be infinite.
  double end(double from, double range);

 private:
  // The ray is looked at in parts, cell by cell: a bit each, whose claims need no sorting. The first part is short, since
  // many rays end soon; a long way costs least in few parts.
  static constexpr int kCells = 64;
  static constexpr int kMaxCells = 256;
  using Cells = std::array<std::uint64_t, kMaxCells / kCells>;

  void look(double from, double range);
  void claim(ConstAtomRef atom);
  static void mark(int first, int last, Cells& cells);
  int firstUnsure(int cell) const;

  const AtomMap& map_;
  Eigen::Vector3f origin_;
  Eigen::Vector3f direction_;
  float radius_;  // m, of an atom
  float cell_;    // m
  float cells_per_metre_;
  int count_ = 0;          // of cells in the part
  double begin_ = 0.0;     // m, of the part
  double end_ = 0.0;       // m, of the part
  Eigen::Vector3f start_;  // of the part
  Cells free_{};           // cells that lie within what one atom says is free
  Cells unsure_{};         // cells that another kind of atom reaches into
};

}  // namespace atom_map
