// What becomes of a file, and of what lies beside it, when it cannot be written.
#include <atomic>
#include <ostream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "../test_folder.h"
#include "atom_mapping/io/write_file.h"

namespace atom_map {
namespace {

class WriteFile : public FolderTest {};

TEST_F(WriteFile, AFailureWhileItIsWrittenLeavesTheOldFileAndNothingElse) {
  writeFile(path("map"), [](std::ostream& out) { out << "old"; });
  const auto fail_halfway = [](std::ostream& out) {
    out << "ne";
    throw std::runtime_error("no more");
  };
  EXPECT_THROW(writeFile(path("map"), fail_halfway), std::runtime_error);
  EXPECT_EQ(contents(path("map")), "old");
  EXPECT_FALSE(std::filesystem::exists(path("map.part")));
}

// Also those of other processes, which the lock does not tell from threads with files of their own.
TEST_F(WriteFile, SeveralWritersOfOneFileLeaveItWholeAtEveryMoment) {
  constexpr std::size_t kSize = 300000;
  constexpr int kWrites = 60;
  const std::string file = path("map");
  writeFile(file, [](std::ostream& out) { out << std::string(kSize, 'a'); });
  std::atomic<int> writing{3};
  std::vector<std::thread> writers;
  for (const char letter : {'a', 'b', 'c'}) {
    writers.emplace_back([&, letter] {
      for (int i = 0; i < kWrites; ++i) {
        EXPECT_NO_THROW(writeFile(file, [&](std::ostream& out) {
          for (std::size_t k = 0; k < 10; ++k) out << std::string(kSize / 10, letter) << std::flush;
        }));
      }
      --writing;
    });
  }
  bool is_whole = true;
  while (is_whole && writing > 0) {
    const std::string read = contents(file);
    is_whole = read.size() == kSize && read == std::string(kSize, read.front());
  }
  EXPECT_TRUE(is_whole);
  for (std::thread& writer : writers) writer.join();
  EXPECT_FALSE(std::filesystem::exists(path("map.part")));
}

}  // namespace
}  // namespace atom_map
