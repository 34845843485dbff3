#include "atom_mapping/query/free_way.h"

#include <algorithm>
#include <cmath>

#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

constexpr double kLook = 16.0;  // atomic radii, along the ray at a time
constexpr float kMargin = 1.0;  // atomic radii, that a regressed distance may fall short of an atom's

}  // namespace

FreeWay::FreeWay(const AtomMap& map, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction)
    : map_(map), origin_(origin), direction_(direction) {}

double FreeWay::end(double from, double range) {
  for (;;) {
    const double end = endOfClaims(from);
    if (end < looked_ || end >= range) return std::min(end, range);
    from = end;
    look(from, std::min(from + kLook * static_cast<double>(map_.radius()), range));
  }
}

double FreeWay::endOfClaims(double from) {
  double end = std::max(from, free_);
  for (; next_ < claims_.size() && claims_[next_].enter <= end; ++next_) {
    const Claim& claim = claims_[next_];
    if (claim.leave <= from) continue;
    if (!claim.is_free) return std::max(from, claim.enter);
    end = free_ = std::max(end, claim.leave);
  }
  return std::max(from, std::min(end, looked_));
}

void FreeWay::look(double from, double to) {
  const auto at = [&](double along) { return Eigen::Vector3f(origin_ + static_cast<float>(along) * direction_); };
  claims_.clear();
  map_.atoms().forEachAlong(at(from), at(to), 2.0F * map_.radius(), [&](ConstAtomRef atom) { claim(atom); });
  std::sort(claims_.begin(), claims_.end(), [](const Claim& a, const Claim& b) { return a.enter < b.enter; });
  next_ = 0;
  free_ = from;
  looked_ = to;
}

void FreeWay::claim(ConstAtomRef atom) {
  const bool is_free = classify(map_, atom) == Occupancy::kFree;
  float reach = 2.0F * map_.radius();
  if (is_free && map_.mode() == Mode::kSignedDistance) reach = std::min(reach, atom.value() - kMargin * map_.radius());
  const Eigen::Vector3f offset = atom.center() - origin_;
  const float along = direction_.dot(offset);
  const float squared_height = (offset - along * direction_).squaredNorm();
  if (reach <= 0.0F || squared_height >= reach * reach) return;
  const auto half_chord = static_cast<double>(std::sqrt(reach * reach - squared_height));
  claims_.push_back({static_cast<double>(along) - half_chord, static_cast<double>(along) + half_chord, is_free});
}

}  // namespace atom_map
