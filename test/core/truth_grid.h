// The truth that planned paths are held against: a grid of the space where a robot could really go, as far as the rays of a
// drive saw it.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <vector>

#include "atom_mapping/sim/coverage.h"
#include "atom_mapping/sim/scene.h"

namespace atom_map {

class TruthGrid {
 public:
  // Cells of side `cell` that a ray crossed and from whose center every surface lies `clearance` or more away (m).
  TruthGrid(const Scene& scene, const std::vector<ObservedRay>& rays, double cell, double clearance)
      : cell_(cell), low_(scene.bounds().min() - Eigen::Vector3d::Constant(1.0)) {
    size_ = ((scene.bounds().sizes().array() + 2.0) / cell).ceil().cast<int>();
    open_.resize(static_cast<std::size_t>(size_.cast<std::int64_t>().prod()));
    for (const ObservedRay& ray : rays) mark(ray);
    for (std::size_t i = 0; i < open_.size(); ++i) {
      open_[i] = open_[i] != 0 && scene.signedDistance(center(i)) >= clearance ? 1 : 0;
    }
  }

  std::size_t openCells() const { return static_cast<std::size_t>(std::count(open_.begin(), open_.end(), 1)); }

  bool isOpen(const Eigen::Vector3d& point) const {
    const auto cell = indexOf(point);
    return cell && open_[*cell] != 0;
  }

  // Length of the shortest way between the centers of two open points' cells, by steps to any of 26 neighbours; nothing if they are not joined.
  std::optional<double> shortest(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    const std::size_t start = *indexOf(from);
    const std::size_t goal = *indexOf(to);
    using Entry = std::pair<float, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    cost_.resize(open_.size(), std::numeric_limits<float>::infinity());
    for (const std::size_t i : touched_) cost_[i] = std::numeric_limits<float>::infinity();
    touched_.assign(1, start);
    cost_[start] = 0.0F;
    queue.push({0.0F, start});
    const auto left = [&](std::size_t i) { return static_cast<float>((center(i) - center(goal)).norm()); };
    while (!queue.empty()) {
      const auto [estimate, i] = queue.top();
      queue.pop();
      if (i == goal) return static_cast<double>(cost_[i]);
      if (estimate > cost_[i] + left(i) + 1e-3F) continue;
      for (int n = 0; n < 27; ++n) {
        const Eigen::Vector3i step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        const auto stride = step.x() + static_cast<std::int64_t>(size_.x()) *
                                           (step.y() + static_cast<std::int64_t>(size_.y()) * step.z());
        const std::size_t j = i + static_cast<std::size_t>(stride);  // the border cells are closed
        const float cost = cost_[i] + static_cast<float>(cell_ * step.cast<double>().norm());
        if (j >= open_.size() || open_[j] == 0 || cost >= cost_[j]) continue;
        cost_[j] = cost;
        touched_.push_back(j);
        queue.push({cost + left(j), j});
      }
    }
    return std::nullopt;
  }

 private:
  std::optional<std::size_t> indexOf(const Eigen::Vector3d& point) const {
    const Eigen::Vector3i cell = ((point - low_) / cell_).array().floor().cast<int>();
    if ((cell.array() < 0).any() || (cell.array() >= size_.array()).any()) return std::nullopt;
    return static_cast<std::size_t>(cell.x() + static_cast<std::int64_t>(size_.x()) *
                                                   (cell.y() + static_cast<std::int64_t>(size_.y()) * cell.z()));
  }

  Eigen::Vector3d center(std::size_t i) const {
    const auto nx = static_cast<std::size_t>(size_.x());
    const auto ny = static_cast<std::size_t>(size_.y());
    return low_ + cell_ * Eigen::Vector3d(0.5 + static_cast<double>(i % nx), 0.5 + static_cast<double>(i / nx % ny),
                                          0.5 + static_cast<double>(i / nx / ny));
  }

  void mark(const ObservedRay& ray) {
    const Eigen::Vector3d along = ray.end - ray.sensor;
    const int steps = static_cast<int>(along.norm() / (0.5 * cell_)) + 1;
    for (int i = 0; i < steps; ++i) {
      const auto cell = indexOf(ray.sensor + static_cast<double>(i) / steps * along);
      if (cell) open_[*cell] = 1;
    }
  }

  double cell_;
  Eigen::Vector3d low_;
  Eigen::Vector3i size_;
  std::vector<std::uint8_t> open_;
  mutable std::vector<float> cost_;
  mutable std::vector<std::size_t> touched_;
};

}  // namespace atom_map
