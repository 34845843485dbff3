// render_map ATOMS.ply --out MAP.png: a picture of a map that atom_mapping_offline exported. Needs no screen.
#include <CLI/CLI.hpp>

#include "atom_mapping/apps/check_output.h"
#include "atom_mapping/apps/run_program.h"
#include "atom_mapping/io/read_atoms.h"
#include "atom_mapping/io/render_atoms.h"

int main(int argc, char** argv) {
  std::string atoms_file;
  std::string png_file = "map.png";
  atom_map::RenderOptions options;
  CLI::App app("Draws the occupied atoms of a map, coloured by height.", "render_map");
  app.add_option("atoms", atoms_file, "PLY file from atom_mapping_offline --export")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--out", png_file, "picture to write, a .png")->capture_default_str();
  app.add_option("--width", options.width, "pixels")->capture_default_str()->check(CLI::Range(16, 8000));
  app.add_option("--height", options.height, "pixels")->capture_default_str()->check(CLI::Range(16, 8000));
  app.add_option("--azimuth", options.azimuth, "where the camera stands, degrees counterclockwise from x")
      ->capture_default_str();
  app.add_option("--elevation", options.elevation, "of the camera, degrees above the horizon")
      ->capture_default_str()
      ->check(CLI::Range(5.0, 85.0));
  app.add_option("--cut-z", options.cut_z, "leave out atoms above this height, m; by default from a ceiling up");
  return atom_mapping::runProgram(app, argc, argv, [&] {
    atom_mapping::checkOutput(png_file, ".png");
    const atom_map::ExportedAtoms atoms = atom_map::readAtoms(atoms_file);
    options.cut_z -= atoms.origin.z();
    atom_map::renderAtoms(atom_map::occupiedCenters(atoms), atoms.radius, options, png_file);
  });
}
