#include "atom_mapping/evaluation/map_picture.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace atom_map {
namespace {

constexpr double kStepsPerRadius = 10.0;
constexpr double kMargin = 3.0;  // radii

}  // namespace

nlohmann::ordered_json unitsToJson(const ComparedMap& map) {
  auto units = nlohmann::ordered_json::array();
  for (const MapUnit& unit : map.list_units()) {
    const Eigen::Vector3d& c = unit.center;
    units.push_back({c.x(), c.y(), c.z(), unit.size, unit.log_odds});
  }
  return units;
}

nlohmann::ordered_json sliceToJson(const ComparedMap& map, const Eigen::AlignedBox3d& bounds, double radius) {
  const double step = radius / kStepsPerRadius;
  const Eigen::Vector3d low = bounds.min() - Eigen::Vector3d::Constant(kMargin * radius);
  const Eigen::Vector3d high = bounds.max() + Eigen::Vector3d::Constant(kMargin * radius);
  const Eigen::Array3i counts = ((high - low) / step).array().round().cast<int>();
  auto rows = nlohmann::ordered_json::array();
  for (int y = 0; y < counts.y(); ++y) {
    auto& row = rows.emplace_back(nlohmann::ordered_json::array());
    for (int x = 0; x < counts.x(); ++x) {
      const auto log_odds = map.log_odds({low.x() + step * (x + 0.5), low.y() + step * (y + 0.5), 0.0});
      row.push_back(log_odds ? nlohmann::ordered_json(*log_odds) : nullptr);
    }
  }
  return {{"min", {low.x(), low.y()}}, {"step", step}, {"rows", rows}};
}

}  // namespace atom_map
