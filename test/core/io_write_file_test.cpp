// What becomes of a file, and of what lies beside it, when it cannot be written.
#include <ostream>
#include <stdexcept>

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

}  // namespace
}  // namespace atom_map
