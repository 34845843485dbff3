#pragma once

#include <std_srvs/Trigger.h>
#include <tf2/buffer_core.h>

#include "atom_mapping/CheckCollision.h"
#include "atom_mapping/MapFile.h"
#include "atom_mapping/QueryOccupancy.h"
#include "atom_mapping/ros/baseline_server.h"
#include "atom_mapping/ros/node_parameters.h"

namespace atom_mapping {

// What MapQueries is for the atom map: the same requests, asked of OctoMap. Unknown is where there is no voxel.
// Thread safety: may be called from several threads at once.
class BaselineQueries {
 public:
  BaselineQueries(BaselineServer& server, const tf2::BufferCore& transforms, const ServiceParameters& parameters)
      : server_(server), transforms_(transforms), parameters_(parameters) {}

  QueryOccupancy::Response answer(const QueryOccupancy::Request& request) const;
  CheckCollision::Response answer(const CheckCollision::Request& request) const;
  // Saves to a .ot or .bt; `atoms` is the number of leaves, `message` names the file with its whole path.
  MapFile::Response answer(const MapFile::Request& request) const;
  std_srvs::Trigger::Response reset();

 private:
  void fill(const QueryOccupancy::Request& request, QueryOccupancy::Response& response) const;
  void fill(const CheckCollision::Request& request, CheckCollision::Response& response) const;

  BaselineServer& server_;
  const tf2::BufferCore& transforms_;
  ServiceParameters parameters_;
};

}  // namespace atom_mapping
