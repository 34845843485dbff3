#pragma once

#include <cstdint>

#include "atom_mapping/base/types.h"
#include "atom_mapping/scan/range_image.h"

namespace atom_map {

// Half the width, in metres, of the thing that the return `ray`, at `point`, lies on: of a pole, a trunk, a person. Measured along the ring,
// to where the returns on both sides jump to a background farther away or stop. Infinite if it is wider than max_width
// or something nearer hides a side.
float halfWidth(const RangeImage& image, std::uint32_t ray, const Eigen::Vector3f& point, float max_width);

// How deep behind a return its occupied atom lies, in metres.
// Choice: behind the front of a thin thing half as deep as elsewhere and never deeper than the thing's middle. Deeper, it
// would lie in space that the rays beside the thing find free.
float depthBehind(const SurfacePoint& point, float radius);

}  // namespace atom_map
