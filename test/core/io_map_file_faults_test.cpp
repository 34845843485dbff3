// Whatever is wrong with a map file, it is refused with the reason.
#include <cmath>
#include <functional>
#include <limits>

#include "atom_mapping/io/hdf5_image.h"
#include "atom_mapping/io/map_file_format.h"
#include "atom_mapping/io/sealed_file.h"
#include "map_file_folder.h"

namespace atom_map {
namespace {

using H5::DataSpace;
using H5::PredType;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Fault {
  std::string name;
  std::function<void(const H5::H5File&)> make;
  std::string reason;
};

template <class Number>
void setNumber(const H5::H5Object& object, const std::string& name, const PredType& type, Number number) {
  if (object.attrExists(name)) object.removeAttr(name);
  object.createAttribute(name, type, DataSpace()).write(type, &number);
}

void setReal(const H5::H5Object& object, const std::string& name, double value) {
  setNumber(object, name, PredType::NATIVE_DOUBLE, value);
}

void setCount(const H5::H5Object& object, const std::string& name, std::uint64_t value) {
  setNumber(object, name, PredType::NATIVE_UINT64, value);
}

void setText(const H5::H5Object& object, const std::string& name, const std::string& text) {
  object.removeAttr(name);
  const H5::StrType type(PredType::C_S1, H5T_VARIABLE);
  object.createAttribute(name, type, DataSpace()).write(type, text);
}

void setVector(const H5::H5Object& object, const std::string& name, const std::vector<double>& values) {
  object.removeAttr(name);
  const hsize_t size = values.size();
  object.createAttribute(name, PredType::NATIVE_DOUBLE, DataSpace(1, &size))
      .write(PredType::NATIVE_DOUBLE, values.data());
}

void setElement(const H5::H5File& image, const std::string& set_name, std::vector<hsize_t> place, float value) {
  const H5::DataSet set = image.openDataSet(set_name);
  const DataSpace target = set.getSpace();
  target.selectElements(H5S_SELECT_SET, 1, place.data());
  set.write(&value, PredType::NATIVE_FLOAT, DataSpace(), target);
}

// Another dataset in the place of one, with nothing written to it.
void replaceSet(const H5::H5File& image, const std::string& name, const PredType& type,
                const std::vector<hsize_t>& sizes, const std::vector<hsize_t>& chunk) {
  image.unlink(name);
  const H5::DSetCreatPropList creation;
  if (!chunk.empty()) creation.setChunk(static_cast<int>(chunk.size()), chunk.data());
  image.createDataSet(name, type, DataSpace(static_cast<int>(sizes.size()), sizes.data()), creation);
}

H5::Group root(const H5::H5File& image) {
  return image.openGroup("/");
}

H5::Group parameters(const H5::H5File& image) {
  return image.openGroup("parameters");
}

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
       "known_planes[0] is no plane"},
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

class MapFileFaults : public MapFile {
 protected:
  void save(Mode mode) { saveMap(copyOf(parametersOf(mode), drawMap(parametersOf(mode), 500, 1)), path("map.h5")); }

  // The file with a change in it, under a new seal that holds.
  std::string changed(const Fault& fault) const {
    const Hdf5Access access;
    const H5::H5File image = openImage(readSealed(path("map.h5")));
    fault.make(image);
    const std::string content = bytesOf(image);
    return write(makeSeal(content) + content);
  }

  void expectEachRefused(const std::vector<Fault>& faults) const {
    for (const Fault& fault : faults) {
      SCOPED_TRACE(fault.name);
      expectRefused(changed(fault), fault.reason);
    }
  }
};

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

TEST_F(MapFileFaults, AFileCutAtAnyLengthIsRefused) {
  save(Mode::kOccupancy);
  const std::string file = write(contents(path("map.h5")) + "x");
  expectRefused(file, "something was added to it: ");
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
  ASSERT_EQ(faultOf(file), "");
  for (std::size_t length = std::filesystem::file_size(file); length-- > 0;) {
    if (length > kSealSize + 100 && length % 31 != 0) continue;
    std::filesystem::resize_file(file, length);
    expectRefused(file, length < 80 ? "it is " : "it is cut short: ");
  }
}

TEST_F(MapFileFaults, AFlippedBitIsRefusedWhereverItIs) {
  save(Mode::kOccupancy);
  const std::size_t size = std::filesystem::file_size(path("map.h5"));
  std::fstream file(path("map.h5"), std::ios::in | std::ios::out | std::ios::binary);
  const auto flip = [&](std::size_t bit) {
    file.seekg(static_cast<std::streamoff>(bit / 8));
    const int byte = file.get();
    file.seekp(static_cast<std::streamoff>(bit / 8));
    file.put(static_cast<char>(byte ^ (1 << (bit % 8)))).flush();
  };
  const auto expectNoticed = [&](std::size_t bit) {
    flip(bit);
    ASSERT_NE(faultOf(path("map.h5")), "") << "bit " << bit;
    flip(bit);
  };
  for (std::size_t bit = 0; bit < 8 * kSealSize; bit += 3) expectNoticed(bit);
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    Random random(seed);
    expectNoticed(drawIndex(random, 8 * size));
  }
  EXPECT_EQ(faultOf(path("map.h5")), "");
}

// HDF5 1.10 dies of some of these.
TEST_F(MapFileFaults, AForgedFileIsLoadedOrRefusedAndHarmsNobody) {
  save(Mode::kOccupancy);
  const std::string good = readSealed(path("map.h5"));
  constexpr std::size_t kHead = 4096;  // bytes, beyond which lie the chunks
  int deaths = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    std::string forged = good;
    for (int i = 0; i < 3; ++i) forged[drawIndex(random, kHead)] = static_cast<char>(drawIndex(random, 256));
    const std::string file = write(makeSeal(forged) + forged);
    const std::string fault = faultOf(file);
    ASSERT_TRUE(fault.empty() || fault.rfind("cannot load " + file + ": ", 0) == 0) << fault;
    deaths += fault.find("reading it ended") != std::string::npos ? 1 : 0;
  }
  RecordProperty("deaths", deaths);
  EXPECT_EQ(faultOf(path("map.h5")), "");
}

TEST_F(MapFileFaults, WhatIsNoMapFileIsRefused) {
  expectRefused(path("missing.h5"), "No such file or directory");
  expectRefused(folder_.string(), "it is no regular file");
  expectRefused("/dev/zero", "it is no regular file");
  expectRefused(write(""), "it is no map file");
  expectRefused(write(std::string(100000, 'x')), "it is no map file");
  expectRefused(write(makeSeal("no HDF5") + "no HDF5"), "HDF5: ");
  expectRefused(write("AtomMap map file, format 2, HDF5 from byte 512 on\nbytes 5 crc32 00000000\n"),
                "it is of format 2");
  expectRefused(write("AtomMap map file, format 1, HDF5 from byte 512 on\nbytes 999999999999999999 "),
                "it is cut short");
}

}  // namespace
}  // namespace atom_map
