// HDF5 files in memory. H5Cpp's functions throw H5::Exception, which is no std::exception.
#pragma once

#include <H5Cpp.h>

#include <mutex>
#include <string>

namespace atom_map {

// An empty file, of the same bytes whenever the same is written to it.
H5::H5File makeImage();

std::string bytesOf(const H5::H5File& image);

// To be read and changed; `bytes` may go.
H5::H5File openImage(std::string bytes);

// Whoever uses HDF5 holds one, and no image beyond it: meanwhile no other thread does, since H5Cpp bears one at a time and
// takes images for one another; and HDF5 does not print to stderr what it throws.
class Hdf5Access {
 public:
  Hdf5Access();
  ~Hdf5Access();
  Hdf5Access(const Hdf5Access&) = delete;
  Hdf5Access& operator=(const Hdf5Access&) = delete;

 private:
  std::unique_lock<std::mutex> lock_;
  H5E_auto2_t print_ = nullptr;
  void* client_data_ = nullptr;
};

}  // namespace atom_map
