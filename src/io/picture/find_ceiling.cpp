#include "atom_mapping/io/picture/find_ceiling.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace atom_map {
namespace {

constexpr float kLeastRoomHeight = 2.0F;  // m
constexpr double kLeastCover = 0.25;      // share of the map's area

// Columns of space, of a square base, in which atoms between two heights lie.
std::size_t countColumns(const std::vector<Eigen::Vector3f>& centers, float side, float low, float high) {
  std::set<std::pair<int, int>> columns;
  for (const Eigen::Vector3f& center : centers) {
    if (center.z() < low || center.z() > high) continue;
    columns.emplace(static_cast<int>(std::floor(center.x() / side)), static_cast<int>(std::floor(center.y() / side)));
  }
  return columns.size();
}

}  // namespace

std::optional<float> findCeiling(const std::vector<Eigen::Vector3f>& centers, float radius) {
  std::vector<float> heights;
  for (const Eigen::Vector3f& center : centers) heights.push_back(center.z());
  std::sort(heights.begin(), heights.end());
  const float floor = heights[heights.size() / 50];
  const float top = heights.back();

  // Coarse columns, since the rings of a lidar leave gaps.
  const float side = std::max(1.0F, 4.0F * radius);
  const float step = 2.0F * radius;
  const auto least =
      static_cast<std::size_t>(kLeastCover * static_cast<double>(countColumns(centers, side, floor, top)));
  for (float level = floor + kLeastRoomHeight; level < top + step; level += step) {
    if (countColumns(centers, side, level, level + step) > least) return level - step;
  }
  return std::nullopt;
}

}  // namespace atom_map
