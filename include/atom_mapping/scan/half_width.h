#pragma once

#include <cstdint>

#include "atom_mapping/scan/filter.h"
#include "atom_mapping/scan/range_image.h"

namespace atom_map {

// Half the width, in metres, of the thing that a return lies on: of a pole, a trunk, a person. Measured along the ring,
// to where the returns on both sides jump to a background farther away or stop. Infinite if it is wider than max_width
// or something nearer hides a side.
float halfWidth(const FilteredScan& scan, const RangeImage& image, std::uint32_t ray, float max_width);

}  // namespace atom_map
