#pragma once

#include <std_msgs/ColorRGBA.h>

namespace atom_mapping {

// Colours that tell heights apart on screen and in print: blue, green, yellow, red for 0 to 1; values beyond are as 0 and
// 1. Opaque.
std_msgs::ColorRGBA colorOf(float value);

}  // namespace atom_mapping
