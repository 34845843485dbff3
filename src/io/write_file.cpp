#include "atom_mapping/io/write_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace atom_map {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& file, int error) {
  throw std::runtime_error("cannot write " + file + ": " + std::generic_category().message(error));
}

// Brings to the disk what a file holds, or a folder's names; 0 or the system's error.
int sync(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno;
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  return error;
}

// A file that one writer has for itself, of all processes, until this goes: others wait.
class OwnFile {
 public:
  // Makes it, if it is not there. Throws as writeFile(file).
  OwnFile(const std::string& path, const std::string& file) {
    do {
      if (descriptor_ >= 0) ::close(descriptor_);
      descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
      if (descriptor_ < 0) fail(file, errno);
      while (::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {  // some network's disks have no locks
      }
    } while (!isAt(path));
  }
  ~OwnFile() { ::close(descriptor_); }
  OwnFile(const OwnFile&) = delete;
  OwnFile& operator=(const OwnFile&) = delete;

 private:
  // Who had it before may have renamed or removed it.
  bool isAt(const std::string& path) const {
    struct stat mine {};
    struct stat there {};
    return ::fstat(descriptor_, &mine) == 0 && ::stat(path.c_str(), &there) == 0 && mine.st_ino == there.st_ino &&
           mine.st_dev == there.st_dev;
  }

  int descriptor_ = -1;
};

}  // namespace

void writeFile(const std::string& file, const std::function<void(std::ostream&)>& write) {
  checkWritable(file);
  const std::string part = file + ".part";
  const OwnFile own(part, file);
  errno = 0;
  std::ofstream out(part, std::ios::binary);
  try {
    if (out) write(out);
    out.close();
    const int written = out ? sync(part) : errno;
    if (!out || written != 0) fail(file, written);
    std::error_code error;
    fs::rename(part, file, error);
    if (error) fail(file, error.value());
  } catch (...) {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw;
  }
  const int renamed = sync(fs::absolute(file).parent_path());
  const bool takes_no_sync =
      renamed == EACCES || renamed == EINVAL;  // a folder that may not be read, some network's disks
  if (renamed != 0 && !takes_no_sync) fail(file, renamed);
}

void checkWritable(const std::string& file) {
  const fs::path folder = fs::absolute(file).parent_path();
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::none) fail(file, error.value());
  if (fs::is_directory(status)) fail(file, EISDIR);
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) fail(file, ENOTDIR);
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(file, errno);
}

}  // namespace atom_map
