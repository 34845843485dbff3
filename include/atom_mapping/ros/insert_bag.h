#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "atom_mapping/ros/bag_reader.h"
#include "atom_mapping/ros/cloud_server.h"

namespace atom_mapping {

// Gives a server the clouds of a bag, one after another, of more than `scans` the first ones; stderr tells how far it is.
// `each` is called with what became of each cloud. Where the stamps begin anew the map is kept, as in the nodes. Throws BadBag,
// also of a bag that holds nothing to map.
void insertBag(BagReader& bag, std::optional<std::size_t> scans, CloudServer& server,
               const std::function<void(const ScanOutcome&)>& each);

}  // namespace atom_mapping
