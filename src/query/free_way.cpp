#include "atom_mapping/query/free_way.h"

#include <algorithm>
#include <cmath>

#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

constexpr double kCell = 0.25;  // atomic radii
constexpr float kMargin = 1.0;  // atomic radii, that a regressed distance may fall short of an atom's

// Bits from `first` to before `last`.
std::uint64_t bitsBetween(double first, double last) {
  constexpr std::uint64_t kAll = ~std::uint64_t{0};
  const int begin = static_cast<int>(std::clamp(first, 0.0, 64.0));
  const int end = static_cast<int>(std::clamp(last, 0.0, 64.0));
  return begin < end ? kAll << begin & kAll >> (64 - end) : 0;
}

}  // namespace

FreeWay::FreeWay(const AtomMap& map, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction)
    : map_(map), origin_(origin), direction_(direction), cell_(kCell * static_cast<double>(map.radius())) {}

double FreeWay::end(double from, double range) {
  for (;;) {
    if (from >= end_) look(from, range);
    const int cell = std::min(static_cast<int>((from - begin_) / cell_), kCells - 1);
    const std::uint64_t unsure = ~(free_ & ~unsure_) >> cell;
    const int first_unsure = unsure == 0 ? kCells : cell + __builtin_ctzll(unsure);
    if (first_unsure == cell) return from;
    from = begin_ + first_unsure * cell_;
    if (from >= range) return range;
    if (first_unsure < kCells) return from;
  }
}

void FreeWay::look(double from, double range) {
  begin_ = from;
  end_ = from + kCells * cell_;
  free_ = 0;
  unsure_ = 0;
  const auto at = [&](double along) { return Eigen::Vector3f(origin_ + static_cast<float>(along) * direction_); };
  map_.atoms().forEachAlong(at(begin_), at(std::min(end_, range)), 2.0F * map_.radius(),
                            [&](ConstAtomRef atom) { claim(atom); });
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
  const double enter = (static_cast<double>(along) - half_chord - begin_) / cell_;
  const double leave = (static_cast<double>(along) + half_chord - begin_) / cell_;
  if (is_free) {
    free_ |= bitsBetween(std::ceil(enter), std::floor(leave));
  } else {
    unsure_ |= bitsBetween(std::floor(enter), std::ceil(leave));
  }
}

}  // namespace atom_map
