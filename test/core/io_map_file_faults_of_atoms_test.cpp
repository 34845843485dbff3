// Each number of a map file's atoms and planes, and the sizes of their arrays, are checked: what cannot be is refused with
// the reason.
#include "map_file_faults.h"

namespace atom_map {
namespace {

using H5::PredType;

std::vector<Fault> faultsOfAtoms(hsize_t atoms) {
  constexpr hsize_t kMany = 1000000000000;
  return {
      {"fewer atoms than rows", [=](auto& f) { setCount(root(f), "atoms", atoms - 1); }, "centers does not have"},
      {"more atoms than rows", [](auto& f) { setCount(root(f), "atoms", ~0ULL); }, "centers does not have"},
      {"no count", [](auto& f) { root(f).removeAttr("atoms"); }, "HDF5: "},
      {"no centres", [](auto& f) { f.unlink("centers"); }, "HDF5: "},
      {"no values", [](auto& f) { f.unlink("log_odds"); }, "HDF5: "},
      {"centres in the plane",
       [=](auto& f) {
         replaceSet(f, "centers", PredType::IEEE_F32LE, {atoms, 2}, {atoms, 1});
       },
       "centers does not have"},
      {"centres in a row", [=](auto& f) { replaceSet(f, "centers", PredType::IEEE_F32LE, {3 * atoms}, {atoms}); },
       "centers does not have"},
      {"centres of doubles",
       [=](auto& f) {
         replaceSet(f, "centers", PredType::IEEE_F64LE, {atoms, 3}, {atoms, 1});
       },
       "is not made of floats"},
      {"centres that were never written",
       [=](auto& f) {
         replaceSet(f, "centers", PredType::IEEE_F32LE, {atoms, 3}, {atoms, 1});
       },
       "centers[1] lies 0 m from"},
      {"values of fewer", [=](auto& f) { replaceSet(f, "log_odds", PredType::IEEE_F32LE, {atoms - 1}, {1}); },
       "log_odds does not have"},
      {"chunks of rows",
       [=](auto& f) {
         replaceSet(f, "centers", PredType::IEEE_F32LE, {atoms, 3}, {atoms, 3});
       },
       "in chunks of one column"},
      {"huge chunks",
       [=](auto& f) {
         setCount(root(f), "atoms", kMany);
         replaceSet(f, "centers", PredType::IEEE_F32LE, {kMany, 3}, {1ULL << 28U, 1});
       },
       "in chunks of one column"},
      {"no chunks",
       [=](auto& f) {
         replaceSet(f, "centers", PredType::IEEE_F32LE, {atoms, 3}, {});
       },
       "in chunks of one column"},
      {"a million millions of atoms",
       [](auto& f) {
         setCount(root(f), "atoms", kMany);
         replaceSet(f, "centers", PredType::IEEE_F32LE, {kMany, 3}, {1000, 1});
         replaceSet(f, "log_odds", PredType::IEEE_F32LE, {kMany}, {1000});
       },
       "centers[1] lies 0 m from"},
      {"a centre of NaN",
       [](auto& f) {
         setElement(f, "centers", {5, 1}, kNan);
       },
       "centers[5] is ("},
      {"a centre at infinity",
       [](auto& f) {
         setElement(f, "centers", {6, 2}, -1.0F / 0.0F);
       },
       "centers[6] is ("},
      {"a centre beyond all cells",
       [](auto& f) {
         setElement(f, "centers", {6, 0}, 1e10F);
       },
       "numbers within"},
      {"log-odds of NaN", [](auto& f) { setElement(f, "log_odds", {7}, kNan); }, "atom 7 holds nan"},
      {"log-odds beyond the clamp", [](auto& f) { setElement(f, "log_odds", {8}, 3.51F); }, "atom 8 holds 3.51"},
  };
}

std::vector<Fault> faultsOfPlanes() {
  constexpr hsize_t kMany = 1000000000000;
  const auto set_plane = [](hsize_t column, float value) {
    return [=](const H5::H5File& f) { setElement(f, "known_planes", {3, column}, value); };
  };
  return {
      {"a place of NaN", set_plane(1, kNan), "known_planes[3] is no plane"},
      {"a place out of this world", set_plane(0, 1e38F), "known_planes[3] is no plane"},
      {"a normal of NaN", set_plane(3, kNan), "known_planes[3] is no plane"},
      {"a long normal", set_plane(4, 2.0F), "known_planes[3] is no plane"},
      {"a level at infinity", set_plane(6, 1.0F / 0.0F), "known_planes[3] is no plane"},
      {"no fits", set_plane(7, 0.0F), "known_planes[3] is no plane"},
      {"fits of NaN", set_plane(7, kNan), "known_planes[3] is no plane"},
      {"fits beyond all numbers", set_plane(7, 1e20F), "known_planes[3] is no plane"},
      {"more planes than rows", [](auto& f) { setCount(root(f), "known_planes", ~0ULL); },
       "known_planes does not have"},
      {"a count without planes", [](auto& f) { f.unlink("known_planes"); }, "HDF5: "},
      {"a million millions of planes",
       [](auto& f) {
         setCount(root(f), "known_planes", kMany);
         replaceSet(f, "known_planes", PredType::IEEE_F32LE, {kMany, 8}, {1000, 1});
       },
       "it tells of 1000000000000 known planes; it may of 1000000"},
      {"planes of seven numbers",
       [](auto& f) {
         replaceSet(f, "known_planes", PredType::IEEE_F32LE, {50, 7}, {50, 1});
       },
       "known_planes does not have"},
  };
}

std::vector<Fault> faultsOfDistances() {
  return {{"a distance of NaN", [](auto& f) { setElement(f, "signed_distance", {2}, kNan); }, "atom 2 holds nan"},
          {"a variance at infinity", [](auto& f) { setElement(f, "variance", {3}, 1.0F / 0.0F); }, "atom 3 holds"},
          {"a negative variance", [](auto& f) { setElement(f, "variance", {4}, -1e-3F); }, "atom 4 holds"},
          {"no variance", [](auto& f) { f.unlink("variance"); }, "HDF5: "},
          {"another mode's", [](auto& f) { setText(parameters(f), "mode", "occupancy"); }, "HDF5: "}};
}

TEST_F(MapFileFaults, EveryAtomIsChecked) {
  save(Mode::kOccupancy);
  expectEachRefused(faultsOfAtoms(loadMap(path("map.h5")).map.atoms().size()));
}

TEST_F(MapFileFaults, EveryPlaneIsChecked) {
  save(Mode::kOccupancy);
  expectEachRefused(faultsOfPlanes());
}

TEST_F(MapFileFaults, AFileFromBeforePlanesWereKnownKnowsNone) {
  save(Mode::kOccupancy);
  const LoadedMap loaded =
      loadMap(changed({"", [](auto& f) { root(f).removeAttr("known_planes"), f.unlink("known_planes"); }, ""}));
  EXPECT_TRUE(loaded.map.planes().empty());
  EXPECT_EQ(loaded.map.atoms().size(), loadMap(path("map.h5")).map.atoms().size());
}

TEST_F(MapFileFaults, EveryDistanceIsChecked) {
  save(Mode::kSignedDistance);
  expectEachRefused(faultsOfDistances());
}

}  // namespace
}  // namespace atom_map
