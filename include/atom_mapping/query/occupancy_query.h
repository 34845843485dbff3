#pragma once

#include <optional>

#include "atom_mapping/query/gaussian_process.h"
#include "atom_mapping/query/occupancy.h"

namespace atom_map {

// Occupancy as the map's users get it: by the Gaussian process or, where gaussian_process/answers_occupancy is off, by
// Eq. (5). One object serves one thread.
class OccupancyQuery {
 public:
  // The map must outlive this.
  OccupancyQuery(const AtomMap& map, const GaussianProcessParameters& parameters)
      : map_(map), by_regression_(parameters.answers_occupancy), process_(map, parameters) {}

  // At a point of the map's local frame. In signed distance mode the negated distance (m), as `interpolate`.
  std::optional<float> logOdds(const Eigen::Vector3f& point) {
    if (!by_regression_) return interpolate(map_, point);
    const auto estimate = process_.estimate(point);
    if (!estimate) return std::nullopt;
    return map_.mode() == Mode::kOccupancy ? estimate->value : -estimate->value;
  }

  // At a point of the map frame.
  Occupancy operator()(const Eigen::Vector3d& point) { return classify(logOdds(map_.toLocal(point))); }

 private:
  const AtomMap& map_;
  bool by_regression_;
  GaussianProcess process_;
};

}  // namespace atom_map
