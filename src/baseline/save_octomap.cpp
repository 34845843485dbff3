#include "atom_mapping/baseline/save_octomap.h"

#include <filesystem>
#include <limits>
#include <stdexcept>

#include "atom_mapping/io/write_file.h"

namespace atom_map {

void checkOctomapFile(const std::string& file) {
  const auto extension = std::filesystem::path(file).extension();
  if (extension == ".ot" || extension == ".bt") return;
  throw std::invalid_argument("cannot tell the format of '" + file + "'; name a file that ends in .ot or .bt");
}

void saveOctomap(octomap::OcTree tree, const std::string& file) {
  checkOctomapFile(file);
  tree.updateInnerOccupancy();
  const bool is_binary = std::filesystem::path(file).extension() == ".bt";
  writeFile(file, [&](std::ostream& out) {
    out.precision(std::numeric_limits<double>::max_digits10);  // of the resolution, which stands there as text
    is_binary ? tree.writeBinary(out) : tree.write(out);
  });
}

}  // namespace atom_map
