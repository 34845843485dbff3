#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <mutex>
#include <string>

#include "atom_mapping/ExtractSurface.h"
#include "atom_mapping/ros/node_parameters.h"
#include "atom_mapping/ros/scan_server.h"

namespace atom_mapping {

// Answers ~extract_surface and publishes what it found on ~surface. Never throws. Works on a copy of the map: scans go on
// meanwhile. One extraction at a time; a second request waits for the first.
class SurfaceService {
 public:
  // `say` is told of the progress of a long extraction, a few times a minute, by the thread that asked.
  SurfaceService(ros::NodeHandle node, const ScanServer& server, const ServiceParameters& parameters,
                 std::function<void(const std::string&)> say);

  ExtractSurface::Response answer(const ExtractSurface::Request& request);

 private:
  void fill(const ExtractSurface::Request& request, ExtractSurface::Response& response);

  const ScanServer& server_;
  ServiceParameters parameters_;
  std::function<void(const std::string&)> say_;
  ros::Publisher publisher_;
  std::mutex mutex_;  // held while extracting
};

}  // namespace atom_mapping
