#include "atom_mapping/io/sealed_file.h"

#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <system_error>

namespace atom_map {
namespace {

namespace fs = std::filesystem;

constexpr int kFormat = 1;

[[noreturn]] void fail(const std::string& reason) {
  throw std::runtime_error(reason);
}

std::string crcOf(const std::string& content) {
  const auto* const bytes = reinterpret_cast<const Bytef*>(content.data());
  std::array<char, 9> text{};
  std::snprintf(text.data(), text.size(), "%08lx", ::crc32_z(0, bytes, content.size()));
  return text.data();
}

// The size of the content that the seal tells.
std::uintmax_t parseSeal(const std::string& seal) {
  static const std::regex kLine("AtomMap map file, format ([0-9]{1,9}), HDF5 from byte 512 on\nbytes ([0-9]{1,18}) ");
  std::smatch match;
  if (!std::regex_search(seal, match, kLine, std::regex_constants::match_continuous)) fail("it is no map file");
  if (std::stoi(match[1]) != kFormat) {
    fail("it is of format " + match[1].str() + ", and this program reads format " + std::to_string(kFormat));
  }
  return std::stoull(match[2]);
}

std::ifstream open(const std::string& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) fail("it is no regular file");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) fail(std::generic_category().message(errno));
  return in;
}

// Of the file that is open and not of its name, which may be another's by now. Leaves it behind the seal.
std::uintmax_t sizeOf(std::ifstream& in) {
  in.clear();  // of having met the end
  const auto end = in.seekg(0, std::ios::end).tellg();
  in.seekg(kSealSize);
  return static_cast<std::uintmax_t>(end);
}

}  // namespace

std::string makeSeal(const std::string& content) {
  std::string seal = "AtomMap map file, format " + std::to_string(kFormat) + ", HDF5 from byte 512 on\nbytes " +
                     std::to_string(content.size()) + " crc32 " + crcOf(content) + "\n";
  seal.resize(kSealSize);
  return seal;
}

std::string readSealed(const std::string& file) {
  std::ifstream in = open(file);
  std::string seal(kSealSize, '\0');
  in.read(seal.data(), kSealSize);
  const std::uintmax_t size = parseSeal(seal);
  const std::uintmax_t there = std::max<std::uintmax_t>(sizeOf(in), kSealSize) - kSealSize;
  if (there != size) {
    fail(std::string(there < size ? "it is cut short: " : "something was added to it: ") + std::to_string(there) +
         " bytes where its seal tells of " + std::to_string(size));
  }
  std::string content(size, '\0');
  in.read(content.data(), static_cast<std::streamsize>(size));
  if (!in) fail("it cannot be read to its end");
  if (makeSeal(content) != seal) fail("it is damaged: its checksum does not hold");
  return content;
}

}  // namespace atom_map
