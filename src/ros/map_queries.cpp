#include "atom_mapping/ros/map_queries.h"

#include "atom_mapping/query/cast_ray.h"
#include "atom_mapping/query/collision.h"
#include "atom_mapping/ros/answer_request.h"
#include "atom_mapping/ros/check_request.h"
#include "atom_mapping/ros/pose_conversion.h"

namespace atom_mapping {
namespace {

using atom_map::AtomMap;
using Eigen::Vector3d;
using Eigen::Vector3f;

}  // namespace

QueryOccupancy::Response MapQueries::answer(const QueryOccupancy::Request& request) const {
  return answered<QueryOccupancy::Response>([&](auto& response) { fill(request, response); });
}

QuerySignedDistance::Response MapQueries::answer(const QuerySignedDistance::Request& request) const {
  return answered<QuerySignedDistance::Response>([&](auto& response) { fill(request, response); });
}

CheckCollision::Response MapQueries::answer(const CheckCollision::Request& request) const {
  return answered<CheckCollision::Response>([&](auto& response) { fill(request, response); });
}

CastRay::Response MapQueries::answer(const CastRay::Request& request) const {
  return answered<CastRay::Response>([&](auto& response) { fill(request, response); });
}

ClearRegion::Response MapQueries::answer(const ClearRegion::Request& request) {
  return answered<ClearRegion::Response>([&](auto& response) { fill(request, response); });
}

std_srvs::Trigger::Response MapQueries::reset() {
  server_.reset();
  std_srvs::Trigger::Response response;
  response.success = 1;
  response.message = "the map is empty";
  return response;
}

void MapQueries::fill(const CheckCollision::Request& request, CheckCollision::Response& response) const {
  const std::size_t size = request.centers.size();
  checkSize("centers", size);
  checkEqualSizes("centers", size, "radii", request.radii.size());
  const float largest = kLargestSphere * static_cast<float>(server_.parameters().radius);
  const atom_map::Pose to_map = toMap(request.frame_id);
  std::vector<Vector3d> centers;
  for (std::size_t i = 0; i < size; ++i) {
    centers.push_back(to_map * checkedPoint(element("centers", i), request.centers[i]));
    checkedSphere(element("radii", i), request.radii[i], largest, request.unknown_is_free != 0);
  }
  for (std::size_t i = 0; i < size; ++i) {
    response.collides.push_back(static_cast<std::uint8_t>(server_.read([&](const AtomMap& map) {
      const Vector3f center = map.toLocal(centers[i]);
      const bool unknown_is_free = request.unknown_is_free != 0;
      if (map.mode() == atom_map::Mode::kOccupancy) {
        return atom_map::collides(map, center, request.radii[i], unknown_is_free);
      }
      atom_map::GaussianProcess distances(map, server_.parameters().gaussian_process);
      return atom_map::collides(map, distances, center, request.radii[i], unknown_is_free);
    })));
  }
}

void MapQueries::fill(const CastRay::Request& request, CastRay::Response& response) const {
  const std::size_t size = request.origins.size();
  checkSize("origins", size);
  checkEqualSizes("origins", size, "directions", request.directions.size());
  const float max_range = checkedLength("max_range", request.max_range);
  const atom_map::Pose to_map = toMap(request.frame_id);
  std::vector<Vector3d> origins;
  std::vector<Vector3d> directions;
  for (std::size_t i = 0; i < size; ++i) {
    origins.push_back(checkedPoint(element("origins", i), request.origins[i]));
    directions.push_back(checkedDirection(element("directions", i), request.directions[i]));
  }
  for (std::size_t i = 0; i < size; ++i) {
    const Vector3f direction = (to_map.linear() * directions[i]).cast<float>();
    const auto ray = server_.read([&](const AtomMap& map) {
      const Vector3f origin = map.toLocal(to_map * origins[i]);
      if (map.mode() == atom_map::Mode::kOccupancy) return atom_map::castRay(map, origin, direction, max_range);
      atom_map::GaussianProcess distances(map, server_.parameters().gaussian_process);
      return atom_map::castRay(map, distances, origin, direction, max_range);
    });
    response.result.push_back(static_cast<std::uint8_t>(ray.end));
    response.ends.push_back(toPoint(origins[i] + static_cast<double>(ray.distance) * directions[i]));
  }
}

void MapQueries::fill(const ClearRegion::Request& request, ClearRegion::Response& response) const {
  response.removed = server_.clearRegion(checkedBox(request.min, request.max));
}

void MapQueries::checkSize(const char* array, std::size_t size) const {
  atom_mapping::checkSize(array, size, parameters_.max_points);
}

atom_map::Pose MapQueries::toMap(const std::string& frame) const {
  return toMapFrame(frame, transforms_, server_.mapFrame());
}

}  // namespace atom_mapping
