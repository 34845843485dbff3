#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "atom_mapping/base/check_parameters.h"
#include "atom_mapping/base/describe_parameters.h"
#include "atom_mapping/io/atom_rows.h"
#include "atom_mapping/io/hdf5_image.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/map_file_format.h"
#include "atom_mapping/io/read_attribute.h"
#include "atom_mapping/io/sealed_file.h"

namespace atom_map {
namespace {

using namespace map_file;
template <class... Parts>
[[noreturn]] void fail(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  throw std::runtime_error(text.str());
}

// For forEachParameter.
struct ParameterReader {
  const H5::Group& group;

  void operator()(const char* name, double& value, const Range& /*range*/) const {
    if (group.attrExists(name)) value = readReal(group, name);
  }
  void operator()(const char* name, std::uint32_t& value, const Range& range) const {
    if (!group.attrExists(name)) return;
    const std::uint64_t number = readCount(group, name);
    if (!range.contains(static_cast<double>(number))) fail(name, " is ", number, ", which is too much");
    value = static_cast<std::uint32_t>(number);
  }
  void operator()(const char* name, bool& value) const {
    if (group.attrExists(name)) value = readCount(group, name) != 0;
  }
  void operator()(const char* name, std::string& value) const {
    if (group.attrExists(name)) value = readText(group, name);
  }
  void operator()(const char* name, Mode& value) const {
    const std::string text = readText(group, name);
    value = text == nameOf(Mode::kOccupancy) ? Mode::kOccupancy : Mode::kSignedDistance;
    if (text != nameOf(value)) fail(name, " is '", text, "'; this program knows occupancy and signed_distance");
  }
};

MappingParameters readParameters(const H5::H5File& image) {
  const H5::Group group = image.openGroup(kParameters);
  for (const char* name : {"map_frame", "mode", "radius", "occupancy/max_log_odds"}) {
    if (!group.attrExists(name)) fail("it does not tell ", name);
  }
  MappingParameters parameters;
  forEachParameter(parameters, ParameterReader{group});
  throwIfFaulty(parameters);
  return parameters;
}

Eigen::Vector3d readOrigin(const H5::Group& root) {
  const Eigen::Vector3d origin = readVector(root, kOrigin);
  if (!origin.allFinite() || origin != Eigen::Vector3d(origin.array().round())) {
    fail("origin is (", origin.transpose(), "); it must be of whole metres");
  }
  return origin;
}

bool isPossible(const std::array<float, 2>& values, const MappingParameters& parameters) {
  if (parameters.mode == Mode::kSignedDistance) {
    return std::isfinite(values[0]) && std::isfinite(values[1]) && values[1] >= 0.0F;
  }
  return std::abs(values[0]) <= static_cast<float>(parameters.occupancy.max_log_odds);
}

void addAtom(hsize_t row, const Eigen::Vector3f& center, const std::array<float, 2>& values,
             const MappingParameters& parameters, AtomMap& map) {
  const float rounding = 1e-6F * center.cwiseAbs().maxCoeff();  // of atoms that were moved
  const float reach = (1.0F - 1e-5F) * AtomMap::kOverlapTolerance * 2.0F * map.radius() - rounding;
  const float farthest = 0x1p30F * map.radius();  // beyond, the index does not tell places apart
  if (!center.allFinite() || center.cwiseAbs().maxCoeff() > farthest) {
    fail("centers[", row, "] is (", center.transpose(), "); it must be of numbers within ", farthest, " m");
  }
  if (!isPossible(values, parameters)) {
    fail("atom ", row, " holds ", values[0], ", ", values[1], ", which mode ", nameOf(parameters.mode), " never gives");
  }
  map.atoms().forEachWithin(center, reach, [&](ConstAtomRef, float squared_distance) {
    fail("centers[", row, "] lies ", std::sqrt(squared_distance), " m from another atom's; no two lie nearer than ",
         reach, " m");
  });
  map.atoms().insert(center, values.data());
}

LoadedMap fromHdf5(std::string content) {
  const H5::H5File image = openImage(std::move(content));
  const H5::Group root = image.openGroup("/");
  const std::uint64_t version = readCount(root, kFormatVersionName);
  if (version != kFormatVersion) fail("it is of format ", version, ", and this program reads format ", kFormatVersion);
  const MappingParameters parameters = readParameters(image);
  LoadedMap loaded{parameters, readCount(root, kScans), AtomMap(parameters.mode, parameters.radius)};
  loaded.map.anchor(readOrigin(root));
  AtomRows(image, parameters.mode, readCount(root, kAtoms))
      .forEach([&](hsize_t row, const auto& center, const auto& values) {
        addAtom(row, center, values, parameters, loaded.map);
      });
  return loaded;
}

}  // namespace

LoadedMap loadMap(const std::string& file) {
  try {
    std::string content = readSealed(file);
    const Hdf5Access access;
    return fromHdf5(std::move(content));
  } catch (const H5::Exception& error) {
    throw std::runtime_error("cannot load " + file + ": HDF5: " + error.getDetailMsg());
  } catch (const std::exception& error) {
    throw std::runtime_error("cannot load " + file + ": " + error.what());
  }
}

}  // namespace atom_map
