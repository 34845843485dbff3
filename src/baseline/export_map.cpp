#include "atom_mapping/baseline/export_map.h"

#include <filesystem>
#include <stdexcept>

#include "atom_mapping/baseline/export_octree.h"
#include "atom_mapping/io/export_atoms.h"
#include "atom_mapping/io/write_file.h"

namespace atom_map {
namespace {

bool isOctree(const std::string& file) {
  return std::filesystem::path(file).extension() == ".bt";
}

}  // namespace

bool isExportable(const std::string& file) {
  return isOctree(file) || isAtomFile(file);
}

void exportMap(const AtomMap& map, const std::string& file) {
  checkMapExport(file);
  isOctree(file) ? exportOctree(map, file) : exportAtoms(map, file);
}

void checkMapExport(const std::string& file) {
  if (!isExportable(file)) {
    throw std::invalid_argument("cannot export to " + file + ": name a file that ends in .ply, .pcd, .csv or .bt");
  }
  checkWritable(file);
}

}  // namespace atom_map
