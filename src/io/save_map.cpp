#include <array>
#include <ostream>
#include <stdexcept>

#include "atom_mapping/base/describe_parameters.h"
#include "atom_mapping/io/hdf5_image.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/map_file_format.h"
#include "atom_mapping/io/sealed_file.h"
#include "atom_mapping/io/write_file.h"

namespace atom_map {
namespace {

using namespace map_file;
using H5::PredType;

// Choice: more effort gains less than 1 % on coordinates and takes twice as long.
constexpr int kDeflate = 1;

void writeText(const H5::H5Object& object, const std::string& name, const std::string& text) {
  H5::StrType type(PredType::C_S1, H5T_VARIABLE);
  type.setCset(H5T_CSET_UTF8);
  object.createAttribute(name, type, H5::DataSpace()).write(type, text);
}

template <class Number>
void writeNumber(const H5::H5Object& object, const std::string& name, const PredType& type, Number number) {
  object.createAttribute(name, type, H5::DataSpace()).write(type, &number);
}

// For forEachParameter.
struct ParameterWriter {
  const H5::H5Object& group;

  void operator()(const char* name, double value, const Range& /*range*/) const {
    writeNumber(group, name, PredType::NATIVE_DOUBLE, value);
  }
  void operator()(const char* name, std::uint32_t value, const Range& /*range*/) const {
    writeNumber(group, name, PredType::NATIVE_UINT32, value);
  }
  void operator()(const char* name, bool value) const {
    writeNumber(group, name, PredType::NATIVE_UINT8, std::uint8_t{value});
  }
  void operator()(const char* name, const std::string& value) const { writeText(group, name, value); }
  void operator()(const char* name, Mode value) const { writeText(group, name, nameOf(value)); }
  void operator()(const char* name, LimitPolicy value) const { writeText(group, name, nameOf(value)); }
};

void writeHead(const MapCopy& map, const H5::H5File& image) {
  const H5::Group root = image.openGroup("/");
  writeNumber(root, kFormatVersionName, PredType::NATIVE_UINT32, kFormatVersion);
  writeNumber(root, kScans, PredType::NATIVE_UINT64, map.scans);
  writeNumber(root, kAtoms, PredType::NATIVE_UINT64, std::uint64_t{map.size()});
  writeNumber(root, kKnownPlanes, PredType::NATIVE_UINT64, std::uint64_t{map.planes.size()});
  const hsize_t three = 3;
  root.createAttribute(kOrigin, PredType::NATIVE_DOUBLE, H5::DataSpace(1, &three))
      .write(PredType::NATIVE_DOUBLE, map.origin.data());
  forEachParameter(map.parameters, ParameterWriter{root.createGroup(kParameters)});
}

// Of `width` columns, a chunk for each stretch of one: so the bytes that resemble one another lie together.
H5::DataSet makeDataSet(const H5::H5File& image, const std::string& name, hsize_t rows, hsize_t width) {
  const std::array<hsize_t, 2> sizes{rows, width};
  const std::array<hsize_t, 2> chunk{std::min<hsize_t>(rows, kChunk), 1};
  const int rank = width == 1 ? 1 : 2;
  const H5::DSetCreatPropList creation;
  constexpr bool kTimes = false;
  H5Pset_obj_track_times(creation.getId(), kTimes);
  if (rows > 0) {
    creation.setChunk(rank, chunk.data());
    creation.setShuffle();
    creation.setDeflate(kDeflate);
    creation.setFletcher32();
  }
  return image.createDataSet(name, PredType::IEEE_F32LE, H5::DataSpace(rank, sizes.data()), creation);
}

void writeColumn(const H5::DataSet& set, hsize_t column, const std::vector<float>& values) {
  const H5::DataSpace target = set.getSpace();
  const std::array<hsize_t, 2> start{0, column};
  const std::array<hsize_t, 2> count{values.size(), 1};
  target.selectHyperslab(H5S_SELECT_SET, count.data(), start.data());
  set.write(values.data(), PredType::NATIVE_FLOAT, H5::DataSpace(1, count.data()), target);
}

void writePlanes(const std::vector<KnownPlane>& planes, const H5::H5File& image) {
  std::array<std::vector<float>, kPlaneWidth> columns;
  for (const auto& [place, normal, level, fits] : planes) {
    const std::array<float, kPlaneWidth> row{place.x(),  place.y(),  place.z(), normal.x(),
                                             normal.y(), normal.z(), level,     fits};
    for (std::size_t c = 0; c < row.size(); ++c) columns[c].push_back(row[c]);
  }
  const H5::DataSet set = makeDataSet(image, kKnownPlanes, planes.size(), kPlaneWidth);
  for (hsize_t c = 0; c < columns.size(); ++c) writeColumn(set, c, columns[c]);
}

std::string toHdf5(const MapCopy& map) {
  const Hdf5Access access;
  const H5::H5File image = makeImage();
  writeHead(map, image);
  const H5::DataSet centers = makeDataSet(image, kCenters, map.size(), 3);
  for (hsize_t c = 0; c < 3; ++c) writeColumn(centers, c, map.columns[c]);
  std::size_t column = 3;
  for (const std::string& name : valueNames(map.parameters.mode)) {
    writeColumn(makeDataSet(image, name, map.size(), 1), 0, map.columns[column++]);
  }
  writePlanes(map.planes, image);
  return bytesOf(image);
}

}  // namespace

void saveMap(const MapCopy& map, const std::string& file) {
  checkWritable(file);
  try {
    const std::string content = toHdf5(map);
    writeFile(file, [&](std::ostream& out) { out << makeSeal(content) << content; });
  } catch (const H5::Exception& error) {
    throw std::runtime_error("cannot write " + file + ": HDF5: " + error.getDetailMsg());
  }
}

}  // namespace atom_map
