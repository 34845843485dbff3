#pragma once

#include <Eigen/Core>
#include <vector>

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
  // What one atom says of the ray, from where to where (m).
  struct Claim {
    double enter;
    double leave;
    bool is_free;  // if not, what it says is that nothing is certain
  };

  void look(double from, double to);
  void claim(ConstAtomRef atom);
  double endOfClaims(double from);

  const AtomMap& map_;
  Eigen::Vector3f origin_;
  Eigen::Vector3f direction_;
  double looked_ = 0.0;        // how far claims_ reach
  double free_ = 0.0;          // how far the claims before next_ say that it is free
  std::size_t next_ = 0;       // of claims_
  std::vector<Claim> claims_;  // by where they enter
};

}  // namespace atom_map
