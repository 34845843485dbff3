// map_info MAP.h5: what a map file holds, once all of it was checked.
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <filesystem>
#include <iomanip>
#include <iostream>

#include "atom_mapping/apps/run_program.h"
#include "atom_mapping/base/describe_parameters.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/map_file_format.h"

namespace {

using atom_map::AtomMap;
using atom_map::LoadedMap;
using atom_map::Mode;
using atom_map::map_file::nameOf;

constexpr int kColumn = 38;  // where the values stand; no name is longer

std::ostream& label(const std::string& text) {
  return std::cout << std::left << std::setw(kColumn) << text << " ";
}

// For forEachParameter.
struct ParameterPrinter {
  template <class Number>
  void operator()(const char* name, const Number& value, const atom_map::Range& /*range*/) const {
    label(std::string("  ") + name) << value << "\n";
  }
  void operator()(const char* name, const std::string& value) const {
    label(std::string("  ") + name) << value << "\n";
  }
  void operator()(const char* name, bool value) const { operator()(name, std::string(value ? "true" : "false")); }
  void operator()(const char* name, Mode value) const { operator()(name, std::string(nameOf(value))); }
  void operator()(const char* name, atom_map::LimitPolicy value) const { operator()(name, std::string(nameOf(value))); }
};

// Occupied, or behind a surface.
bool isSolid(const AtomMap& map, const atom_map::ConstAtomRef& atom) {
  return map.mode() == Mode::kOccupancy ? atom.value() > 0.0F : atom.value() < 0.0F;
}

void printAtoms(const AtomMap& map, std::uintmax_t file_bytes) {
  const std::size_t atoms = map.atoms().size();
  std::size_t solid = 0;
  Eigen::AlignedBox3d extent;
  map.atoms().forEach([&](const atom_map::ConstAtomRef& atom) {
    solid += isSolid(map, atom) ? 1 : 0;
    extent.extend(map.toMap(atom.center()));
  });
  label("atoms") << atoms << "\n";
  if (atoms == 0) return;
  label(map.mode() == Mode::kOccupancy ? "  occupied" : "  behind a surface") << solid << "\n";
  label("  centres from (m)") << extent.min().transpose() << "\n";
  label("  to") << extent.max().transpose() << "\n";
  label("bytes") << file_bytes << ", " << static_cast<double>(file_bytes) / static_cast<double>(atoms) << " an atom\n";
}

void print(const std::string& file) {
  const LoadedMap loaded = atom_map::loadMap(file);
  label("map") << file << ", whole\n";
  label("scans") << loaded.scans << "\n";
  label("origin (m)") << (loaded.map.origin().array() + 0.0).transpose() << "\n";
  printAtoms(loaded.map, std::filesystem::file_size(file));
  std::cout << "parameters\n";
  atom_map::forEachParameter(loaded.parameters, ParameterPrinter{});
}

}  // namespace

int main(int argc, char** argv) {
  std::string file;
  CLI::App app("Prints what a map file holds, once all of it was checked.", "map_info");
  app.add_option("map", file, "From ~save_map or atom_mapping_offline --save")->required();
  return atom_mapping::runProgram(app, argc, argv, [&] {
    std::cout << std::setprecision(9);  // of coordinates far from the origin
    print(file);
  });
}
