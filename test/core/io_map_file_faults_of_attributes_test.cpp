// Each attribute of a map file that is missing, of another type or out of its bounds has the file refused with the reason;
// one that came with a later version may be missing.
#include <cmath>

#include "map_file_faults.h"

namespace atom_map {
namespace {

using H5::DataSpace;
using H5::PredType;

std::vector<Fault> faultsOfAttributes() {
  return {
      {"of a later format", [](auto& f) { setCount(root(f), "format_version", 2); }, "it is of format 2, and this"},
      {"of no format", [](auto& f) { root(f).removeAttr("format_version"); }, "HDF5: "},
      {"a text for a number",
       [](auto& f) {
         root(f).removeAttr("scans"), root(f).createAttribute("scans", H5::StrType(PredType::C_S1, 8), DataSpace());
       },
       "scans is not a whole number"},
      {"no scans", [](auto& f) { root(f).removeAttr("scans"); }, "HDF5: "},
      {"no origin", [](auto& f) { root(f).removeAttr("origin"); }, "HDF5: "},
      {"an origin in the plane",
       [](auto& f) {
         setVector(root(f), "origin", {1, 2});
       },
       "origin is not three real"},
      {"a long origin", [](auto& f) { setVector(root(f), "origin", std::vector<double>(1000, 1.0)); },
       "origin is not three real"},
      {"an origin between metres",
       [](auto& f) {
         setVector(root(f), "origin", {1, 2.5, 3});
       },
       "origin is (  1 2.5   3); it must"},
      {"an origin nowhere",
       [](auto& f) {
         setVector(root(f), "origin", {1, 2, double{kNan}});
       },
       "it must be of whole metres"},
      {"an origin at infinity",
       [](auto& f) {
         setVector(root(f), "origin", {1, 2, HUGE_VAL});
       },
       "it must be of whole metres"},
      {"no parameters", [](auto& f) { f.unlink("parameters"); }, "HDF5: "},
      {"no mode", [](auto& f) { parameters(f).removeAttr("mode"); }, "it does not tell mode"},
      {"no radius", [](auto& f) { parameters(f).removeAttr("radius"); }, "it does not tell radius"},
      {"no frame", [](auto& f) { parameters(f).removeAttr("map_frame"); }, "it does not tell map_frame"},
      {"no clamp", [](auto& f) { parameters(f).removeAttr("occupancy/max_log_odds"); },
       "it does not tell occupancy/max_log_odds"},
      {"an unknown mode", [](auto& f) { setText(parameters(f), "mode", "tsdf"); },
       "mode is 'tsdf'; this program knows"},
      {"an unknown policy", [](auto& f) { setText(parameters(f), "limits/policy", "forget"); },
       "limits/policy is 'forget'; this program knows"},
      {"a number for a mode", [](auto& f) { setReal(parameters(f), "mode", 1.0); }, "mode is not a text"},
      {"a mode of another's", [](auto& f) { setText(parameters(f), "mode", "signed_distance"); }, "HDF5: "},
      {"an empty frame", [](auto& f) { setText(parameters(f), "map_frame", ""); }, "map_frame is empty"},
      {"a negative radius", [](auto& f) { setReal(parameters(f), "radius", -1.0); }, "radius is -1; it must lie"},
      {"a radius of NaN", [](auto& f) { setReal(parameters(f), "radius", double{kNan}); },
       "radius is nan; it must lie"},
      {"a whole radius", [](auto& f) { setCount(parameters(f), "radius", 1); }, "radius is not a real number"},
      {"many radii", [](auto& f) { setVector(parameters(f), "radius", std::vector<double>(1000, 0.25)); },
       "radius is not a real"},
      {"a larger radius", [](auto& f) { setReal(parameters(f), "radius", 1.0); },
       "from another atom's; no two lie nearer"},
      {"a smaller clamp", [](auto& f) { setReal(parameters(f), "occupancy/max_log_odds", 1.0); },
       "which mode occupancy never gives"},
      {"a range below zero", [](auto& f) { setReal(parameters(f), "scan/max_range", -5.0); }, "scan/max_range is -5"},
      {"a seed of 40 bits", [](auto& f) { setCount(parameters(f), "seed", 1ULL << 40U); },
       "seed is 1099511627776, which"},
  };
}

TEST_F(MapFileFaults, AChangeUnderANewSealIsNoFaultInItself) {
  save(Mode::kOccupancy);
  EXPECT_EQ(faultOf(changed({"", [](auto& f) { setReal(parameters(f), "scan/max_range", 30.0); }, ""})), "");
  EXPECT_EQ(faultOf(changed({"", [](auto& f) { parameters(f).removeAttr("rays/lambda"); }, ""})), "");
}

TEST_F(MapFileFaults, AFileFromBeforeThereWereLimitsHasNone) {
  MappingParameters limited = parametersOf(Mode::kOccupancy);
  limited.limits = {1000, 5.0, LimitPolicy::kForgetFarthest, 50.0};
  saveMap(copyOf(limited, drawMap(limited, 500, 1)), path("map.h5"));
  const LoadedMap loaded = loadMap(changed(
      {"",
       [](auto& f) {
         for (const char* name : {"limits/max_atoms", "limits/max_megabytes", "limits/policy", "limits/window"}) {
           parameters(f).removeAttr(name);
         }
       },
       ""}));
  EXPECT_EQ(loaded.parameters.limits.max_atoms, 0U);
  EXPECT_EQ(loaded.parameters.limits.max_megabytes, 0.0);
  EXPECT_EQ(loaded.parameters.limits.policy, LimitPolicy::kRefuse);
  EXPECT_EQ(loaded.parameters.limits.window, 0.0);
}

TEST_F(MapFileFaults, EveryAttributeIsChecked) {
  save(Mode::kOccupancy);
  expectEachRefused(faultsOfAttributes());
}

}  // namespace
}  // namespace atom_map
