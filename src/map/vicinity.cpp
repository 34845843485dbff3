#include "atom_mapping/map/vicinity.h"

namespace atom_map {

void Vicinity::lookUp(const Eigen::Vector3f& p) {
  const Eigen::Vector3f corner = side_ * (p / side_).array().floor();
  block_ = {corner, corner + Eigen::Vector3f::Constant(side_)};
  block_.extend(p);  // rounding may have left it outside
  const Eigen::Vector3f reach = Eigen::Vector3f::Constant(radius_);
  leaves_.clear();
  boxes_.clear();
  tree_.forEachLeaf({block_.min() - reach, block_.max() + reach}, search_,
                    [&](AtomBlock& leaf, const Floats& min, const Floats& max) {
                      leaf.prefetch();
                      for (std::uint32_t first = 0; first == 0 || first < leaf.size(); first += AtomBlock::kMaskSize) {
                        add({&leaf, first}, min, max);
                      }
                    });
  leaves_.resize(boxes_.size() * kLane, {&empty_, 0});
  near_.resize(leaves_.size() + 1);
}

void Vicinity::add(const Atoms& atoms, const Floats& min, const Floats& max) {
  const auto lane = static_cast<std::uint32_t>(leaves_.size() % kLane);
  leaves_.push_back(atoms);
  if (lane == 0) boxes_.emplace_back();
  boxes_.back().set(lane, min, max);
}

}  // namespace atom_map
