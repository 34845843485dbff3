// The queries of MapQueries that ask the map at points.
#include <algorithm>
#include <optional>

#include "atom_mapping/query/gaussian_process.h"
#include "atom_mapping/query/occupancy_query.h"
#include "atom_mapping/ros/check_request.h"
#include "atom_mapping/ros/map_queries.h"

namespace atom_mapping {
namespace {

using atom_map::AtomMap;
using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr std::size_t kSlice = 64;  // points asked for at once, some 0.5 ms

// A signed distance tells on which side of the surface a point lies, and nothing between.
float probabilityOf(const AtomMap& map, std::optional<float> value) {
  if (map.mode() == atom_map::Mode::kOccupancy || !value) return atom_map::probability(value);
  return atom_map::classify(value) == atom_map::Occupancy::kOccupied ? 1.0F : 0.0F;
}

void checkStoresDistances(atom_map::Mode mode) {
  if (mode == atom_map::Mode::kSignedDistance) return;
  throw Refusal("the map is in occupancy mode; start the node with mode: signed_distance to ask for distances");
}

}  // namespace

void MapQueries::fill(const QueryOccupancy::Request& request, QueryOccupancy::Response& response) const {
  const auto points = checkedPoints(request.points, toMap(request.frame_id));
  forEachPoint<atom_map::OccupancyQuery>(points, [&](const AtomMap& map, const Vector3f& point, auto& query) {
    const std::optional<float> value = query.logOdds(point);
    response.state.push_back(static_cast<std::uint8_t>(atom_map::classify(value)));
    response.probability.push_back(probabilityOf(map, value));
  });
}

void MapQueries::fill(const QuerySignedDistance::Request& request, QuerySignedDistance::Response& response) const {
  checkStoresDistances(server_.parameters().mode);
  const atom_map::Pose to_map = toMap(request.frame_id);
  const auto points = checkedPoints(request.points, to_map);
  const Eigen::Matrix3f to_frame = to_map.linear().transpose().cast<float>();
  forEachPoint<atom_map::GaussianProcess>(points, [&](const AtomMap& map, const Vector3f& point, auto& process) {
    checkStoresDistances(map.mode());  // another may have been loaded meanwhile
    const auto estimate = process.estimate(point);
    const Vector3f gradient = estimate ? Vector3f(to_frame * estimate->gradient) : Vector3f::Zero();
    response.known.push_back(static_cast<std::uint8_t>(estimate.has_value()));
    response.distance.push_back(estimate ? estimate->value : 0.0F);
    response.variance.push_back(estimate ? estimate->variance : 0.0F);
    geometry_msgs::Vector3 vector;
    vector.x = gradient.x();
    vector.y = gradient.y();
    vector.z = gradient.z();
    response.gradient.push_back(vector);
  });
}

// Calls ask(map, point in its local frame, query) for each point, a slice at a time.
template <class Query, class Ask>
void MapQueries::forEachPoint(const std::vector<Vector3d>& points, Ask&& ask) const {
  for (std::size_t begin = 0; begin < points.size(); begin += kSlice) {
    server_.read([&](const AtomMap& map) {
      Query query(map, server_.parameters().gaussian_process);
      for (std::size_t i = begin; i < std::min(begin + kSlice, points.size()); ++i) {
        ask(map, map.toLocal(points[i]), query);
      }
    });
  }
}

// In the map frame.
std::vector<Vector3d> MapQueries::checkedPoints(const std::vector<geometry_msgs::Point>& points,
                                                const atom_map::Pose& to_map) const {
  checkSize("points", points.size());
  std::vector<Vector3d> checked;
  checked.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    checked.push_back(to_map * checkedPoint(element("points", i), points[i]));
  }
  return checked;
}

}  // namespace atom_mapping
