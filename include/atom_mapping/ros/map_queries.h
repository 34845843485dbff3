#pragma once

#include <std_srvs/Trigger.h>
#include <tf2/buffer_core.h>

#include "atom_mapping/CastRay.h"
#include "atom_mapping/CheckCollision.h"
#include "atom_mapping/ClearRegion.h"
#include "atom_mapping/QueryOccupancy.h"
#include "atom_mapping/QuerySignedDistance.h"
#include "atom_mapping/ros/node_parameters.h"
#include "atom_mapping/ros/scan_server.h"

namespace atom_mapping {

// Answers the requests of the services. Never throws: a request that cannot be served leaves the map as it is and gets a
// message that says what is wrong and what to do.
// Thread safety: may be called from several threads at once. Takes hold of the map for a short while at a time, so that
// scans go on meanwhile; a long request may therefore see the map before and after a scan.
class MapQueries {
 public:
  static constexpr float kLargestSphere = 32.0F;  // atomic radii; a longer search for unknown space would hold scans up

  MapQueries(ScanServer& server, const tf2::BufferCore& transforms, const ServiceParameters& parameters)
      : server_(server), transforms_(transforms), parameters_(parameters) {}

  QueryOccupancy::Response answer(const QueryOccupancy::Request& request) const;
  QuerySignedDistance::Response answer(const QuerySignedDistance::Request& request) const;
  CheckCollision::Response answer(const CheckCollision::Request& request) const;
  CastRay::Response answer(const CastRay::Request& request) const;
  ClearRegion::Response answer(const ClearRegion::Request& request);
  std_srvs::Trigger::Response reset();

 private:
  void fill(const QueryOccupancy::Request& request, QueryOccupancy::Response& response) const;
  void fill(const QuerySignedDistance::Request& request, QuerySignedDistance::Response& response) const;
  void fill(const CheckCollision::Request& request, CheckCollision::Response& response) const;
  void fill(const CastRay::Request& request, CastRay::Response& response) const;
  void fill(const ClearRegion::Request& request, ClearRegion::Response& response) const;
  template <class Query, class Ask>
  void forEachPoint(const std::vector<Eigen::Vector3d>& points, Ask&& ask) const;
  std::vector<Eigen::Vector3d> checkedPoints(const std::vector<geometry_msgs::Point>& points,
                                             const atom_map::Pose& to_map) const;
  void checkSize(const char* array, std::size_t size) const;
  atom_map::Pose toMap(const std::string& frame) const;

  ScanServer& server_;
  const tf2::BufferCore& transforms_;
  ServiceParameters parameters_;
};

}  // namespace atom_mapping
