// A file whose first 512 bytes vouch for the rest: two lines of text that tell its size and CRC-32, then zeros. HDF5 skips
// such a "user block", so that its own tools read the file as it is.
//
// Choice: HDF5 1.10 crashes or hangs on one damaged file in a hundred; it never sees one whose seal is broken. A file that
// was forged, seal and all, is what loadMap reads HDF5 in another process for.
#pragma once

#include <cstddef>
#include <string>

namespace atom_map {

constexpr std::size_t kSealSize = 512;  // bytes

std::string makeSeal(const std::string& content);

// What follows the seal. Throws std::runtime_error that says in what way the file is no map file, of another format, cut
// short or damaged; the file's name is the caller's to add.
std::string readSealed(const std::string& file);

}  // namespace atom_map
