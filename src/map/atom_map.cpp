#include "atom_mapping/map/atom_map.h"

#include <stdexcept>
#include <string>

namespace atom_map {

AtomMap::AtomMap(Mode mode, double radius)
    : mode_(mode), radius_(static_cast<float>(radius)), atoms_(radius_, mode == Mode::kOccupancy ? 1 : 2) {
  if (!(radius > 0.0)) throw std::invalid_argument("radius is " + std::to_string(radius) + " m; it must be positive");
}

void AtomMap::anchor(const Eigen::Vector3d& point) {
  if (atoms_.size() > 0) return;
  origin_ = point.array().round();
  planes_.clear();
}

std::size_t AtomMap::clearRegion(const Eigen::AlignedBox3d& box) {
  return atoms_.removeInBox({toLocal(box.min()), toLocal(box.max())});
}

void AtomMap::reset() {
  atoms_.clear();
  planes_ = {};
  origin_.setZero();
}

}  // namespace atom_map
