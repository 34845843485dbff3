#pragma once

#include <string>

namespace atom_mapping {

// tf had leading slashes, which old drivers and bags still write; tf2 refuses them.
inline std::string withoutSlash(const std::string& frame) {
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

}  // namespace atom_mapping
