// Any file at all is loaded or refused, by this process, in time. What the fuzzer makes of a file is sealed anew, so that it
// comes past the checksum: HDF5 meets it, in the process that loadMap gives it, and may die there.
#include <pthread.h>
#include <sanitizer/common_interface_defs.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/sealed_file.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

// One that is not on a disk.
const std::string& fileName() {
  static const std::string name = "/dev/shm/map_file_fuzz_" + std::to_string(getpid()) + ".h5";
  static const int removed_at_exit = std::atexit([] { unlink(fileName().c_str()); });
  static_cast<void>(removed_at_exit);
  return name;
}

}  // namespace

// What kills the process that reads is no finding: in there the sanitizers must not tell libFuzzer, which would leave a crash-*
// file of it.
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  return pthread_atfork(nullptr, nullptr, [] { __sanitizer_set_death_callback(nullptr); });
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  constexpr std::size_t kSeal = atom_map::kSealSize;
  if (size <= kSeal || max_size <= kSeal || seed % 16 == 0) return LLVMFuzzerMutate(data, size, max_size);
  const std::size_t content = LLVMFuzzerMutate(data + kSeal, size - kSeal, max_size - kSeal);
  const std::string seal = atom_map::makeSeal({reinterpret_cast<const char*>(data + kSeal), content});
  std::memcpy(data, seal.data(), kSeal);
  return kSeal + content;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::ofstream(fileName(), std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    atom_map::loadMap(fileName());
  } catch (const std::runtime_error&) {
  }
  return 0;
}
