#include "atom_mapping/ros/surface_service.h"

#include <visualization_msgs/Marker.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "atom_mapping/io/write_mesh.h"
#include "atom_mapping/ros/answer_request.h"
#include "atom_mapping/ros/check_request.h"
#include "atom_mapping/ros/map_snapshot.h"
#include "atom_mapping/ros/surface_messages.h"
#include "atom_mapping/surface/extract_surface.h"

namespace atom_mapping {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kSayPeriod{5};

bool isZero(const geometry_msgs::Point& point) {
  return point.x == 0.0 && point.y == 0.0 && point.z == 0.0;
}

// Empty, which is everywhere, where both corners are zero.
Eigen::AlignedBox3d boxOf(const ExtractSurface::Request& request) {
  if (isZero(request.min) && isZero(request.max)) return {};
  return checkedBox(request.min, request.max);
}

}  // namespace

SurfaceService::SurfaceService(ros::NodeHandle node, const ScanServer& server, const ServiceParameters& parameters,
                               std::function<void(const std::string&)> say)
    : server_(server),
      parameters_(parameters),
      say_(std::move(say)),
      publisher_(node.advertise<visualization_msgs::Marker>("surface", 1, true)) {}

ExtractSurface::Response SurfaceService::answer(const ExtractSurface::Request& request) {
  const std::lock_guard lock(mutex_);
  return answered<ExtractSurface::Response>([&](auto& response) { fill(request, response); });
}

void SurfaceService::fill(const ExtractSurface::Request& request, ExtractSurface::Response& response) {
  const std::string file = request.file.empty() ? "" : checkedFile(request.file);
  if (!file.empty()) atom_map::checkMeshFile(file);
  atom_map::SurfaceRequest wanted;
  wanted.box = boxOf(request);
  wanted.resolution = checkedLength("resolution", request.resolution);
  wanted.threads = std::max(1U, std::thread::hardware_concurrency());
  wanted.max_cells = parameters_.max_points;
  Clock::time_point next = Clock::now() + kSayPeriod;
  wanted.progress = [&](std::size_t points) {
    if (Clock::now() < next) return;
    say_("Extracting the surface, " + std::to_string(points) + " points evaluated so far");
    next = Clock::now() + kSayPeriod;
  };
  const MapSnapshot snapshot = takeSnapshot(server_);
  const atom_map::SurfaceMesh mesh = atom_map::extractSurface(toAtomMap(snapshot), server_.parameters(), wanted);
  if (!file.empty()) atom_map::writeMesh(mesh, file);
  response.mesh = toMesh(mesh);
  response.variance = mesh.variance;
  std_msgs::Header header;
  header.frame_id = snapshot.frame;
  header.stamp = snapshot.stamp;
  publisher_.publish(toSurfaceMarker(mesh, header));
}

}  // namespace atom_mapping
