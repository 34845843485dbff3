#include "atom_mapping/query/free_way.h"

#include <algorithm>
#include <cmath>

#include "atom_mapping/base/floor_to_int.h"
#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

constexpr float kCell = 0.25F;   // atomic radii
constexpr float kMargin = 1.0F;  // atomic radii, that a regressed distance may fall short of an atom's

}  // namespace

FreeWay::FreeWay(const AtomMap& map, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction)
    : map_(map),
      origin_(origin),
      direction_(direction),
      radius_(map.radius()),
      cell_(kCell * radius_),
      cells_per_metre_(1.0F / cell_),
      start_(origin) {}

double FreeWay::end(double from, double range) {
  for (;;) {
    if (from >= end_) look(from, range);
    const int cell = std::min(static_cast<int>((from - begin_) * static_cast<double>(cells_per_metre_)), count_ - 1);
    const int unsure = firstUnsure(cell);
    if (unsure == cell) return from;
    from = begin_ + unsure * static_cast<double>(cell_);
    if (from >= range) return range;
    if (unsure < count_) return from;
  }
}

void FreeWay::look(double from, double range) {
  count_ = std::clamp(4 * count_, kCells, kMaxCells);
  begin_ = from;
  end_ = from + count_ * static_cast<double>(cell_);
  free_ = {};
  unsure_ = {};
  const auto at = [&](double along) { return Eigen::Vector3f(origin_ + static_cast<float>(along) * direction_); };
  start_ = at(begin_);
  map_.atoms().forEachAlong(start_, at(std::min(end_, range)), 2.0F * radius_, [&](ConstAtomRef atom) { claim(atom); });
}

void FreeWay::claim(ConstAtomRef atom) {
  const bool is_free = classify(map_, atom) == Occupancy::kFree;
  float reach = 2.0F * radius_;
  if (is_free && map_.mode() == Mode::kSignedDistance) reach = std::min(reach, atom.value() - kMargin * radius_);
  const Eigen::Vector3f offset = atom.center() - start_;
  const float along = direction_.dot(offset);
  const float squared_half_chord = reach * reach - (offset - along * direction_).squaredNorm();
  if (reach <= 0.0F || squared_half_chord <= 0.0F) return;
  const float half_chord = std::sqrt(squared_half_chord);
  const float enter = (along - half_chord) * cells_per_metre_;
  const float leave = (along + half_chord) * cells_per_metre_;
  if (is_free) {
    mark(floorToInt(enter) + 1, floorToInt(leave), free_);
  } else {
    mark(floorToInt(enter), floorToInt(leave) + 1, unsure_);
  }
}

// Cells from `first` to before `last`.
void FreeWay::mark(int first, int last, Cells& cells) {
  constexpr std::uint64_t kAll = ~std::uint64_t{0};
  auto begin = static_cast<unsigned>(std::max(first, 0));
  const auto end = static_cast<unsigned>(std::clamp(last, 0, kMaxCells));
  while (begin < end) {
    const unsigned word = begin / kCells;
    const unsigned end_in_word = std::min(end - word * kCells, unsigned{kCells});
    cells[word] |= kAll << (begin % kCells) & kAll >> (kCells - end_in_word);
    begin = (word + 1) * kCells;
  }
}

// From a cell on; `count_` where there is none.
int FreeWay::firstUnsure(int cell) const {
  for (int first = cell; first < count_; first = (first / kCells + 1) * kCells) {
    const auto word = static_cast<std::size_t>(first / kCells);
    const std::uint64_t unsure = ~(free_[word] & ~unsure_[word]) >> (first % kCells);
    if (unsure != 0) return first + __builtin_ctzll(unsure);
  }
  return count_;
}

}  // namespace atom_map
