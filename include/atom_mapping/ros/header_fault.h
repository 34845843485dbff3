#pragma once

#include <std_msgs/Header.h>

#include <optional>
#include <string>

namespace atom_mapping {

// What makes a header unfit for tf, for a person; nothing for a good one.
std::optional<std::string> headerFault(const std_msgs::Header& header);

}  // namespace atom_mapping
