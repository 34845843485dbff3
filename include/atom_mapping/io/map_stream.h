// A map on its way from who reads the file's HDF5 to who believes nothing of it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "atom_mapping/io/map_file.h"

namespace atom_map {

// Sends what a map file holds behind its seal. Throws std::runtime_error where it is not laid out as map_file.h tells; does
// not look at values. HDF5 may crash or hang on `content`.
void sendMap(std::string content, const std::function<void(const void*, std::size_t)>& send);

// Receives what sendMap sends and checks every value: throws std::runtime_error with the first that cannot be, or what
// `receive` throws. `receive` gives the next bytes, as many as asked for.
LoadedMap receiveMap(const std::function<void(void*, std::size_t)>& receive);

}  // namespace atom_map
