#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "atom_mapping/io/write_file.h"

namespace atom_mapping {

// To be asked before the work begins: throws std::runtime_error where the file does not end in `ending`, such as ".h5", by which
// others tell what it holds, or cannot be written.
inline void checkOutput(const std::string& file, const std::string& ending) {
  if (std::filesystem::path(file).extension() != ending) {
    throw std::runtime_error("cannot write " + file + ": name a file that ends in " + ending);
  }
  atom_map::checkWritable(file);
}

}  // namespace atom_mapping
