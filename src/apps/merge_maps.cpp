// merge_maps A.h5 B.h5 --out C.h5: two robots' maps, or two days', made one.
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <iostream>
#include <vector>

#include "atom_mapping/apps/check_output.h"
#include "atom_mapping/apps/run_program.h"
#include "atom_mapping/base/angles.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/query/combine_maps.h"
#include "atom_mapping/ros/fit_to_limits.h"

namespace {

using atom_map::LoadedMap;

// Of x y z in metres and roll pitch yaw in degrees (REP 103).
atom_map::Pose toPose(const std::vector<double>& t) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  return Eigen::Translation3d(t[0], t[1], t[2]) * AngleAxisd(t[5] * atom_map::kDegree, Vector3d::UnitZ()) *
         AngleAxisd(t[4] * atom_map::kDegree, Vector3d::UnitY()) *
         AngleAxisd(t[3] * atom_map::kDegree, Vector3d::UnitX());
}

void checkAlike(const LoadedMap& a, const LoadedMap& b) {
  if (a.map.mode() != b.map.mode()) {
    throw std::runtime_error(
        "one map is in occupancy mode and the other in signed distance mode; name two of one mode");
  }
  if (a.map.radius() == b.map.radius()) return;
  throw std::runtime_error("their radii are " + std::to_string(a.map.radius()) + " m and " +
                           std::to_string(b.map.radius()) + " m; name two maps of one radius");
}

void merge(const std::string& a_file, const std::string& b_file, const atom_map::Pose& b_to_a, const std::string& out) {
  atom_mapping::checkOutput(out, ".h5");
  LoadedMap a = atom_map::loadMap(a_file);
  const LoadedMap b = atom_map::loadMap(b_file);
  checkAlike(a, b);
  const atom_map::MergeReport report = atom_map::mergeInto(a.map, atom_map::transformed(b.map, b_to_a), a.parameters);
  const std::string fault = "cannot write " + out + " within the limits of " + a_file +
                            ", which are those of the node that loaded it and saved it last";
  const std::size_t forgotten = atom_mapping::fitToLimits(fault, a.parameters.limits, a.map.origin(), a.map);
  std::cout << out << ": " << a.map.atoms().size() << " atoms, " << report.inserted << " of them from " << b_file
            << ", " << report.updates << " updates";
  if (forgotten > 0) std::cout << "; the limits of " << a_file << " left no room for " << forgotten;
  std::cout << "\n";
  atom_map::Mapper mapper(a.parameters);
  mapper.replace(std::move(a.map), a.scans + b.scans);
  atom_map::saveMap(atom_map::copyMap(mapper), out);
}

}  // namespace

int main(int argc, char** argv) {
  std::string a;
  std::string b;
  std::string out;
  std::vector<double> transform(6, 0.0);
  CLI::App app("Merges map B into map A as a scan is merged; frame, parameters and limits of the outcome are A's.",
               "merge_maps");
  app.add_option("A", a, "Map file")->required();
  app.add_option("B", b, "Map file")->required();
  app.add_option("--transform", transform, "B's frame to A's: x y z (m) roll pitch yaw (deg)")->expected(6);
  app.add_option("--out", out, "Map file to write, a .h5; may be A or B")->required();
  return atom_mapping::runProgram(app, argc, argv, [&] { merge(a, b, toPose(transform), out); });
}
