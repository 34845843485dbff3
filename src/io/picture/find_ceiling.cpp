#include "atom_mapping/io/picture/find_ceiling.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace atom_map {
namespace {

constexpr float kLeastRoomHeight = 2.0F;  // m
constexpr double kLeastCover = 0.25;      // share of the map's area

// A column of space of a square base.
std::pair<int, int> columnOf(const Eigen::Vector3f& center, float side) {
  return {static_cast<int>(std::floor(center.x() / side)), static_cast<int>(std::floor(center.y() / side))};
}

}  // namespace

std::optional<float> findCeiling(const std::vector<Eigen::Vector3f>& centers, float radius) {
  std::vector<float> heights;
  for (const Eigen::Vector3f& center : centers) heights.push_back(center.z());
  std::sort(heights.begin(), heights.end());
  const float floor = heights[heights.size() / 50];

  // Coarse columns, since the rings of a lidar leave gaps.
  const float side = std::max(1.0F, 4.0F * radius);
  const float step = 2.0F * radius;
  std::set<std::pair<int, int>> columns;
  std::map<long, std::set<std::pair<int, int>>> levels;  // those with atoms
  for (const Eigen::Vector3f& center : centers) {
    if (center.z() < floor) continue;
    columns.insert(columnOf(center, side));
    const float above = center.z() - floor - kLeastRoomHeight;
    if (above >= 0.0F) levels[static_cast<long>(above / step)].insert(columnOf(center, side));
  }
  const auto least = static_cast<std::size_t>(kLeastCover * static_cast<double>(columns.size()));
  for (const auto& [level, covered] : levels) {
    if (covered.size() > least) return floor + kLeastRoomHeight + static_cast<float>(level - 1) * step;
  }
  return std::nullopt;
}

}  // namespace atom_map
