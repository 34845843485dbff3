// What the tests of faulty map files share: changes of a file's content, each under a seal that holds.
#pragma once

#include <H5Cpp.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "atom_mapping/io/hdf5_image.h"
#include "atom_mapping/io/sealed_file.h"
#include "map_file_folder.h"

namespace atom_map {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Fault {
  std::string name;
  std::function<void(const H5::H5File&)> make;
  std::string reason;
};

template <class Number>
void setNumber(const H5::H5Object& object, const std::string& name, const H5::PredType& type, Number number) {
  if (object.attrExists(name)) object.removeAttr(name);
  object.createAttribute(name, type, H5::DataSpace()).write(type, &number);
}

inline void setReal(const H5::H5Object& object, const std::string& name, double value) {
  setNumber(object, name, H5::PredType::NATIVE_DOUBLE, value);
}

inline void setCount(const H5::H5Object& object, const std::string& name, std::uint64_t value) {
  setNumber(object, name, H5::PredType::NATIVE_UINT64, value);
}

inline void setText(const H5::H5Object& object, const std::string& name, const std::string& text) {
  object.removeAttr(name);
  const H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
  object.createAttribute(name, type, H5::DataSpace()).write(type, text);
}

inline void setVector(const H5::H5Object& object, const std::string& name, const std::vector<double>& values) {
  object.removeAttr(name);
  const hsize_t size = values.size();
  object.createAttribute(name, H5::PredType::NATIVE_DOUBLE, H5::DataSpace(1, &size))
      .write(H5::PredType::NATIVE_DOUBLE, values.data());
}

inline void setElement(const H5::H5File& image, const std::string& set_name, std::vector<hsize_t> place, float value) {
  const H5::DataSet set = image.openDataSet(set_name);
  const H5::DataSpace target = set.getSpace();
  target.selectElements(H5S_SELECT_SET, 1, place.data());
  set.write(&value, H5::PredType::NATIVE_FLOAT, H5::DataSpace(), target);
}

// Another dataset in the place of one, with nothing written to it.
inline void replaceSet(const H5::H5File& image, const std::string& name, const H5::PredType& type,
                       const std::vector<hsize_t>& sizes, const std::vector<hsize_t>& chunk) {
  image.unlink(name);
  const H5::DSetCreatPropList creation;
  if (!chunk.empty()) creation.setChunk(static_cast<int>(chunk.size()), chunk.data());
  image.createDataSet(name, type, H5::DataSpace(static_cast<int>(sizes.size()), sizes.data()), creation);
}

inline H5::Group root(const H5::H5File& image) {
  return image.openGroup("/");
}

inline H5::Group parameters(const H5::H5File& image) {
  return image.openGroup("parameters");
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

}  // namespace atom_map
