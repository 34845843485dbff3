#pragma once

#include <string>

#include "atom_mapping/MapFile.h"

namespace atom_mapping {

inline MapFile::Request at(const std::string& file) {
  MapFile::Request request;
  request.file = file;
  return request;
}

}  // namespace atom_mapping
