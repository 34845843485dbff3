#pragma once

#include <pcl/PCLPointCloud2.h>

#include "atom_mapping/map/atom_map.h"

namespace atom_map {

// A row an atom, in the tree's order, with the columns that exportAtoms tells of, packed.
pcl::PCLPointCloud2 toTable(const AtomMap& map);

}  // namespace atom_map
