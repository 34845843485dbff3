// HDF5 files in memory. H5Cpp's functions throw H5::Exception, which is no std::exception.
#pragma once

#include <H5Cpp.h>

#include <string>

namespace atom_map {

// An empty file, of the same bytes whenever the same is written to it.
H5::H5File makeImage();

std::string bytesOf(const H5::H5File& image);

// To be read and changed; `bytes` may go.
H5::H5File openImage(std::string bytes);

// While it lives, this thread's HDF5 does not print to stderr what it throws.
class QuietHdf5 {
 public:
  QuietHdf5();
  ~QuietHdf5();
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* client_data_ = nullptr;
};

}  // namespace atom_map
