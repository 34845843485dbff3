// Parameters of the node alone, beside the core's (base/parameters.h). As there: these defaults are the only ones, and
// config/atom_mapping.yaml repeats them.
#pragma once

#include <cstdint>
#include <string>

#include "atom_mapping/base/describe_parameters.h"

namespace atom_mapping {

// input/
struct InputParameters {
  double transform_timeout = 1.0;  // s of wall time that a cloud waits for its transform
  std::uint32_t queue_size = 20;   // clouds that wait for their transforms, and as many again for being mapped
};

enum class AtomColor { kHeight, kOccupancy, kDistance };

// publish/
struct PublishParameters {
  double period = 1.0;                   // s of wall time between two publications of the map
  AtomColor color = AtomColor::kHeight;  // of the markers; kDistance in signed distance mode only
  double surface_threshold = 0.25;       // m, signed distance mode: atoms nearer to a surface are in ~atoms
  bool free_atoms = false;               // whether there is a ~free_atoms
  std::uint32_t max_markers = 500000;    // spheres in a marker; of more atoms an even choice is shown
};

// services/
struct ServiceParameters {
  std::uint32_t max_points = 1000000;  // points, spheres or rays in a request, cells of a surface
};

// storage/
struct StorageParameters {
  std::string load;      // map file to start from, by its radius and mode; empty: none
  std::string autosave;  // .h5 that is kept up to date and written at shutdown, not there yet or `load`; empty: none
  double autosave_period = 60.0;  // s of wall time between two
};

struct NodeParameters {
  InputParameters input;
  PublishParameters publish;
  ServiceParameters services;
  StorageParameters storage;
};

// As atom_map::forEachParameter.
template <class Parameters, class Visit>
void forEachNodeParameter(Parameters& p, Visit&& visit) {
  using atom_map::Range;
  visit("input/transform_timeout", p.input.transform_timeout, Range{0.0, 60.0});
  visit("input/queue_size", p.input.queue_size, Range{1.0, 10000.0});

  visit("publish/period", p.publish.period, Range{0.01, 3600.0});
  visit("publish/color", p.publish.color);
  visit("publish/surface_threshold", p.publish.surface_threshold, Range{0.0, 100.0});
  visit("publish/free_atoms", p.publish.free_atoms);
  visit("publish/max_markers", p.publish.max_markers, Range{1.0, 1e8});

  visit("services/max_points", p.services.max_points, Range{1.0, 1e8});

  visit("storage/load", p.storage.load);
  visit("storage/autosave", p.storage.autosave);
  visit("storage/autosave_period", p.storage.autosave_period, Range{0.1, 1e6});
}

}  // namespace atom_mapping
