#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace atom_map {

// Calls write(stream) on a file beside `file` (FILE.part) that takes its place once it is whole and on the disk: who reads
// `file` meanwhile, or after a failure, a kill or a power cut, finds the old one. Of several writers
// of one file, in whatever process, all but one wait. Throws std::runtime_error with the file and the system's reason.
void writeFile(const std::string& file, const std::function<void(std::ostream&)>& write);

// Throws as writeFile would, where the folder is not there or takes no files, or `file` is a folder.
void checkWritable(const std::string& file);

}  // namespace atom_map
