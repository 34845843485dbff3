#include "atom_mapping/io/hdf5_image.h"

namespace atom_map {
namespace {

constexpr std::size_t kGrowth = 1U << 20U;  // bytes that an image grows by
constexpr bool kNoFile = false;             // an image is never written to a file by HDF5
constexpr const char* kAnyName = "map";

H5::FileAccPropList inMemory() {
  H5::FileAccPropList access;
  access.setCore(kGrowth, kNoFile);
  return access;
}

}  // namespace

H5::H5File makeImage() {
  const H5::FileCreatPropList creation;
  constexpr bool kTimes = false;
  H5Pset_obj_track_times(creation.getId(), kTimes);
  return H5::H5File(kAnyName, H5F_ACC_TRUNC, creation, inMemory());
}

std::string bytesOf(const H5::H5File& image) {
  image.flush(H5F_SCOPE_LOCAL);
  const ssize_t size = H5Fget_file_image(image.getId(), nullptr, 0);
  std::string bytes(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
  if (H5Fget_file_image(image.getId(), bytes.data(), bytes.size()) < 0) {
    throw H5::FileIException("bytesOf", "H5Fget_file_image failed");
  }
  return bytes;
}

H5::H5File openImage(std::string bytes) {
  const H5::FileAccPropList access = inMemory();
  if (H5Pset_file_image(access.getId(), bytes.data(), bytes.size()) < 0) {
    throw H5::PropListIException("openImage", "H5Pset_file_image failed");
  }
  return H5::H5File(kAnyName, H5F_ACC_RDWR, H5::FileCreatPropList::DEFAULT, access);
}

Hdf5Access::Hdf5Access() {
  static std::mutex access;  // of what is one in a process anyway
  lock_ = std::unique_lock(access);
  H5Eget_auto2(H5E_DEFAULT, &print_, &client_data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Access::~Hdf5Access() {
  H5Eset_auto2(H5E_DEFAULT, print_, client_data_);
}

}  // namespace atom_map
