#include "atom_mapping/ros/baseline_queries.h"

#include "atom_mapping/baseline/save_octomap.h"
#include "atom_mapping/ros/answer_request.h"
#include "atom_mapping/ros/check_request.h"

namespace atom_mapping {

namespace {

using atom_map::OctomapBaseline;
using Eigen::Vector3d;

constexpr float kLargestSphere = 32.0F;  // voxels; a longer search for unknown space would hold scans up

}  // namespace

QueryOccupancy::Response BaselineQueries::answer(const QueryOccupancy::Request& request) const {
  return answered<QueryOccupancy::Response>([&](auto& response) { fill(request, response); });
}

CheckCollision::Response BaselineQueries::answer(const CheckCollision::Request& request) const {
  return answered<CheckCollision::Response>([&](auto& response) { fill(request, response); });
}

MapFile::Response BaselineQueries::answer(const MapFile::Request& request) const {
  return answered<MapFile::Response>([&](MapFile::Response& response) {
    const std::string file = checkedFile(request.file);
    atom_map::checkOctomapFile(file);
    const octomap::OcTree copy = server_.read([](const OctomapBaseline& map) { return octomap::OcTree(map.tree()); });
    atom_map::saveOctomap(copy, file);
    response.atoms = copy.getNumLeafNodes();
    response.message = "saved " + std::to_string(response.atoms) + " leaves to " + file;
  });
}

std_srvs::Trigger::Response BaselineQueries::reset() {
  server_.reset();
  std_srvs::Trigger::Response response;
  response.success = 1;
  response.message = "the map is empty";
  return response;
}

void BaselineQueries::fill(const QueryOccupancy::Request& request, QueryOccupancy::Response& response) const {
  checkSize("points", request.points.size(), parameters_.max_points);
  const atom_map::Pose to_map = toMapFrame(request.frame_id, transforms_, server_.mapFrame());
  for (std::size_t i = 0; i < request.points.size(); ++i) {
    const Vector3d point = to_map * checkedPoint(element("points", i), request.points[i]);
    const auto log_odds = server_.read([&](const OctomapBaseline& map) { return map.logOdds(point); });
    response.state.push_back(static_cast<std::uint8_t>(atom_map::classify(log_odds)));
    response.probability.push_back(atom_map::probability(log_odds));
  }
}

void BaselineQueries::fill(const CheckCollision::Request& request, CheckCollision::Response& response) const {
  const std::size_t size = request.centers.size();
  checkSize("centers", size, parameters_.max_points);
  checkEqualSizes("centers", size, "radii", request.radii.size());
  const double resolution = server_.read([](const OctomapBaseline& map) { return map.tree().getResolution(); });
  const float largest = kLargestSphere * static_cast<float>(resolution);
  const bool unknown_is_free = request.unknown_is_free != 0;
  const atom_map::Pose to_map = toMapFrame(request.frame_id, transforms_, server_.mapFrame());
  for (std::size_t i = 0; i < size; ++i) {
    const Vector3d center = to_map * checkedPoint(element("centers", i), request.centers[i]);
    const float radius = checkedSphere(element("radii", i), request.radii[i], largest, unknown_is_free);
    response.collides.push_back(static_cast<std::uint8_t>(server_.read([&](const OctomapBaseline& map) {
      return map.collides(center, static_cast<double>(radius), unknown_is_free);
    })));
  }
}

}  // namespace atom_mapping
