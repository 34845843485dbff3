#include "atom_mapping/io/read_attribute.h"

#include <memory>
#include <stdexcept>

namespace atom_map {
namespace {

// HDF5 converts between kinds of numbers and writes as many as there are: both must be asked for before.
H5::Attribute openAttribute(const H5::H5Object& object, const std::string& name, H5T_class_t kind, hssize_t size,
                            const char* expected) {
  H5::Attribute attribute = object.openAttribute(name);
  if (attribute.getTypeClass() != kind || attribute.getSpace().getSimpleExtentNpoints() != size) {
    throw std::runtime_error(name + " is not " + expected);
  }
  return attribute;
}

}  // namespace

double readReal(const H5::H5Object& object, const std::string& name) {
  double value = 0.0;
  openAttribute(object, name, H5T_FLOAT, 1, "a real number").read(H5::PredType::NATIVE_DOUBLE, &value);
  return value;
}

std::uint64_t readCount(const H5::H5Object& object, const std::string& name) {
  std::uint64_t value = 0;
  openAttribute(object, name, H5T_INTEGER, 1, "a whole number").read(H5::PredType::NATIVE_UINT64, &value);
  return value;
}

std::string readText(const H5::H5Object& object, const std::string& name) {
  const H5::Attribute attribute = openAttribute(object, name, H5T_STRING, 1, "a text");
  if (!attribute.getDataType().isVariableStr()) throw std::runtime_error(name + " is not a text of variable length");
  char* text = nullptr;
  attribute.read(attribute.getDataType(), static_cast<void*>(&text));
  const std::unique_ptr<char, herr_t (*)(void*)> owner(text, H5free_memory);
  if (text == nullptr) throw std::runtime_error(name + " is not a text");
  return text;
}

Eigen::Vector3d readVector(const H5::H5Object& object, const std::string& name) {
  Eigen::Vector3d vector;
  openAttribute(object, name, H5T_FLOAT, 3, "three real numbers").read(H5::PredType::NATIVE_DOUBLE, vector.data());
  return vector;
}

}  // namespace atom_map
