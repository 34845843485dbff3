// A map file that was cut, of which a bit was flipped, that was forged, and what is no map file: refused, and nobody harmed.
#include <filesystem>
#include <fstream>

#include "map_file_faults.h"

namespace atom_map {
namespace {

TEST_F(MapFileFaults, AFileCutAtAnyLengthIsRefused) {
  save(Mode::kOccupancy);
  const std::string file = write(contents(path("map.h5")) + "x");
  expectRefused(file, "something was added to it: ");
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
  ASSERT_EQ(faultOf(file), "");
  for (std::size_t length = std::filesystem::file_size(file); length-- > 0;) {
    if (length > kSealSize + 100 && length % 31 != 0) continue;
    std::filesystem::resize_file(file, length);
    expectRefused(file, length < 80 ? "it is " : "it is cut short: ");
  }
}

TEST_F(MapFileFaults, AFlippedBitIsRefusedWhereverItIs) {
  save(Mode::kOccupancy);
  const std::size_t size = std::filesystem::file_size(path("map.h5"));
  std::fstream file(path("map.h5"), std::ios::in | std::ios::out | std::ios::binary);
  const auto flip = [&](std::size_t bit) {
    file.seekg(static_cast<std::streamoff>(bit / 8));
    const int byte = file.get();
    file.seekp(static_cast<std::streamoff>(bit / 8));
    file.put(static_cast<char>(byte ^ (1 << (bit % 8)))).flush();
  };
  const auto expectNoticed = [&](std::size_t bit) {
    flip(bit);
    ASSERT_NE(faultOf(path("map.h5")), "") << "bit " << bit;
    flip(bit);
  };
  for (std::size_t bit = 0; bit < 8 * kSealSize; bit += 3) expectNoticed(bit);
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    Random random(seed);
    expectNoticed(drawIndex(random, 8 * size));
  }
  EXPECT_EQ(faultOf(path("map.h5")), "");
}

// HDF5 1.10 dies of some of these.
TEST_F(MapFileFaults, AForgedFileIsLoadedOrRefusedAndHarmsNobody) {
  save(Mode::kOccupancy);
  const std::string good = readSealed(path("map.h5"));
  constexpr std::size_t kHead = 4096;  // bytes, beyond which lie the chunks
  int deaths = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    std::string forged = good;
    for (int i = 0; i < 3; ++i) forged[drawIndex(random, kHead)] = static_cast<char>(drawIndex(random, 256));
    const std::string file = write(makeSeal(forged) + forged);
    const std::string fault = faultOf(file);
    ASSERT_TRUE(fault.empty() || fault.rfind("cannot load " + file + ": ", 0) == 0) << fault;
    deaths += fault.find("reading it ended") != std::string::npos ? 1 : 0;
  }
  RecordProperty("deaths", deaths);
  EXPECT_EQ(faultOf(path("map.h5")), "");
}

TEST_F(MapFileFaults, WhatIsNoMapFileIsRefused) {
  expectRefused(path("missing.h5"), "No such file or directory");
  expectRefused(folder_.string(), "it is no regular file");
  expectRefused("/dev/zero", "it is no regular file");
  expectRefused(write(""), "it is no map file");
  expectRefused(write(std::string(100000, 'x')), "it is no map file");
  expectRefused(write(makeSeal("no HDF5") + "no HDF5"), "HDF5: ");
  expectRefused(write("AtomMap map file, format 2, HDF5 from byte 512 on\nbytes 5 crc32 00000000\n"),
                "it is of format 2");
  expectRefused(write("AtomMap map file, format 1, HDF5 from byte 512 on\nbytes 999999999999999999 "),
                "it is cut short");
}

}  // namespace
}  // namespace atom_map
