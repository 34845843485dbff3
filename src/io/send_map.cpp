#include <stdexcept>

#include "atom_mapping/base/describe_parameters.h"
#include "atom_mapping/io/file_rows.h"
#include "atom_mapping/io/hdf5_image.h"
#include "atom_mapping/io/map_file_format.h"
#include "atom_mapping/io/map_stream.h"
#include "atom_mapping/io/read_attribute.h"

namespace atom_map {
namespace {

using namespace map_file;
using Send = std::function<void(const void*, std::size_t)>;

// For forEachParameter. What is not there keeps its value.
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
    if (value.size() > kLongestText) fail(name, " has ", value.size(), " bytes; it may have ", kLongestText);
  }
  void operator()(const char* name, Mode& value) const {
    const std::string text = readText(group, name);
    value = text == nameOf(Mode::kOccupancy) ? Mode::kOccupancy : Mode::kSignedDistance;
    if (text != nameOf(value)) fail(name, " is '", text, "'; this program knows occupancy and signed_distance");
  }
  void operator()(const char* name, LimitPolicy& value) const {
    if (!group.attrExists(name)) return;
    const std::string text = readText(group, name);
    value = text == nameOf(LimitPolicy::kRefuse) ? LimitPolicy::kRefuse : LimitPolicy::kForgetFarthest;
    if (text != nameOf(value)) fail(name, " is '", text, "'; this program knows refuse and forget_farthest");
  }
};

// For forEachParameter.
struct ParameterSender {
  const Send& send;

  template <class Number>
  void operator()(const char* /*name*/, const Number& value, const Range& /*range*/) const {
    send(&value, sizeof value);
  }
  void operator()(const char* /*name*/, const std::string& value) const {
    const std::uint64_t size = value.size();
    send(&size, sizeof size);
    send(value.data(), value.size());
  }
  void operator()(const char* /*name*/, bool value) const { sendByte(value ? 1 : 0); }
  void operator()(const char* /*name*/, Mode value) const { sendByte(value == Mode::kOccupancy ? 0 : 1); }
  void operator()(const char* /*name*/, LimitPolicy value) const { sendByte(value == LimitPolicy::kRefuse ? 0 : 1); }
  void sendByte(std::uint8_t byte) const { send(&byte, 1); }
};

MappingParameters readParameters(const H5::H5File& image) {
  const H5::Group group = image.openGroup(kParameters);
  for (const char* name : {"map_frame", "mode", "radius", "occupancy/max_log_odds"}) {
    if (!group.attrExists(name)) fail("it does not tell ", name);
  }
  MappingParameters parameters;
  forEachParameter(parameters, ParameterReader{group});
  return parameters;
}

void send(const H5::H5File& image, const Send& send) {
  const H5::Group root = image.openGroup("/");
  const std::uint64_t version = readCount(root, kFormatVersionName);
  if (version != kFormatVersion) fail("it is of format ", version, ", and this program reads format ", kFormatVersion);
  const MappingParameters parameters = readParameters(image);
  const std::uint64_t scans = readCount(root, kScans);
  const std::uint64_t atoms = readCount(root, kAtoms);
  const Eigen::Vector3d origin = readVector(root, kOrigin);
  const std::uint64_t planes = root.attrExists(kKnownPlanes) ? readCount(root, kKnownPlanes) : 0;
  FileRows atom_rows(atoms);
  atom_rows.add(image, kCenters, 3);
  for (const std::string& name : valueNames(parameters.mode)) atom_rows.add(image, name, 1);
  FileRows plane_rows(planes);
  if (planes > 0) plane_rows.add(image, kKnownPlanes, kPlaneWidth);
  forEachParameter(parameters, ParameterSender{send});
  send(&scans, sizeof scans);
  send(origin.data(), 3 * sizeof(double));
  send(&atoms, sizeof atoms);
  const auto send_column = [&](const std::vector<float>& column) {
    send(column.data(), column.size() * sizeof(float));
  };
  atom_rows.forEachColumn(send_column);
  send(&planes, sizeof planes);
  plane_rows.forEachColumn(send_column);
}

}  // namespace

void sendMap(std::string content, const Send& send_bytes) {
  try {
    send(openImage(std::move(content)), send_bytes);
  } catch (const H5::Exception& error) {
    throw std::runtime_error("HDF5: " + error.getDetailMsg());
  }
}

}  // namespace atom_map
