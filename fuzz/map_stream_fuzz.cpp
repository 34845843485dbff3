// Whatever the process that reads HDF5 says, it becomes a map of numbers in which no two atoms overlap, or is refused.
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "atom_mapping/io/map_stream.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto receive = [&](void* bytes, std::size_t count) {
    if (count > size) throw std::runtime_error("it ends too early");
    std::memcpy(bytes, data, count);
    data += count;
    size -= count;
  };
  try {
    const atom_map::LoadedMap loaded = atom_map::receiveMap(receive);
    loaded.map.atoms().forEach([&](atom_map::ConstAtomRef atom) {
      if (!atom.center().allFinite() || !std::isfinite(atom.value())) std::abort();
    });
  } catch (const std::runtime_error&) {
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
