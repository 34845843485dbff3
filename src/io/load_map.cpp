#include <memory>
#include <stdexcept>

#include "atom_mapping/io/apart.h"
#include "atom_mapping/io/hdf5_image.h"
#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/map_stream.h"
#include "atom_mapping/io/sealed_file.h"

namespace atom_map {
namespace {

constexpr unsigned kLeastSeconds = 10;                       // of CPU time for reading a file
constexpr std::size_t kLeastMemory = std::size_t{2} << 30U;  // bytes
constexpr std::size_t kCopies = 4;                           // of the content, that HDF5 holds at once and one to spare
constexpr std::size_t kBytesPerSecond = 1U << 20U;           // of a larger file; far less than HDF5 reads

// Choice: HDF5 1.10 crashes or hangs on some files that were forged, seal and all. It reads in a process of its own, which
// may; every value is checked here.
LoadedMap loadApart(const std::string& content) {
  const auto start = [&] {
    const Hdf5Access access;  // lest the child finds HDF5 in the middle of what another thread does
    const auto seconds = kLeastSeconds + static_cast<unsigned>(content.size() / kBytesPerSecond);
    return std::make_unique<Apart>([&](const Apart::Send& send) { sendMap(content, send); }, seconds,
                                   kLeastMemory + kCopies * content.size());
  };
  const auto reader = start();
  return receiveMap([&](void* bytes, std::size_t size) { reader->receive(bytes, size); });
}

}  // namespace

LoadedMap loadMap(const std::string& file) {
  try {
    return loadApart(readSealed(file));
  } catch (const std::exception& error) {
    throw std::runtime_error("cannot load " + file + ": " + error.what());
  }
}

}  // namespace atom_map
