// Attributes of HDF5 objects. Each throws std::runtime_error that names the attribute where it is of another kind or size
// than asked for, H5::Exception where it is not there.
#pragma once

#include <H5Cpp.h>

#include <Eigen/Core>
#include <cstdint>
#include <string>

namespace atom_map {

double readReal(const H5::H5Object& object, const std::string& name);
std::uint64_t readCount(const H5::H5Object& object, const std::string& name);
std::string readText(const H5::H5Object& object, const std::string& name);
Eigen::Vector3d readVector(const H5::H5Object& object, const std::string& name);

}  // namespace atom_map
