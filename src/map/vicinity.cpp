#include "atom_mapping/map/vicinity.h"

namespace atom_map {

void Vicinity::lookUp(const Eigen::Vector3f& p) {
  const Eigen::Vector3f corner = side_ * (p / side_).array().floor();
  block_ = {corner, corner + Eigen::Vector3f::Constant(side_)};
  block_.extend(p);  // rounding may have left it outside
  const Eigen::Vector3f reach = Eigen::Vector3f::Constant(radius_);
  leaves_.clear();
  atoms_.forEachLeaf({block_.min() - reach, block_.max() + reach},
                     [&](AtomBlock& block, const Eigen::AlignedBox3f& box) {
                       leaves_.push_back({&block, box});
                     });
}

}  // namespace atom_map
