// No kill and no full disk, at any moment of saving, costs the map that was saved before.
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "check_map.h"
#include "map_file_folder.h"

namespace atom_map {
namespace {

// Kills of a process that saves; ATOM_MAPPING_KILLS asks for more.
int killCount() {
  const char* const wanted = std::getenv("ATOM_MAPPING_KILLS");
  return wanted == nullptr ? 20 : std::atoi(wanted);
}

// Saves one map after the other until it is killed.
[[noreturn]] void saveForEver(const MapCopy& first, const MapCopy& second, const std::string& file) {
  for (;;) {
    saveMap(first, file);
    saveMap(second, file);
  }
}

TEST_F(MapFile, KillingWhoeverSavesLeavesAWholeMap) {
  const MappingParameters parameters = parametersOf(Mode::kOccupancy);
  const MapCopy first = copyOf(parameters, drawMap(parameters, 20000, 1), 1);
  const MapCopy second = copyOf(parameters, drawMap(parameters, 30000, 2), 2);
  saveMap(first, path("map.h5"));
  Random random(3);
  int kills_in_writing = 0;
  for (int i = 0; i < killCount(); ++i) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) saveForEver(first, second, path("map.h5"));
    usleep(static_cast<useconds_t>(draw(random, 0.0F, 60e3F)));
    ASSERT_EQ(kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
    kills_in_writing += std::filesystem::exists(path("map.h5.part")) ? 1 : 0;
    const LoadedMap loaded = loadMap(path("map.h5"));
    ASSERT_TRUE(loaded.scans == 1 || loaded.scans == 2);
    ASSERT_EQ(loaded.map.atoms().size(), (loaded.scans == 1 ? first : second).size());
  }
  RecordProperty("kills", killCount());
  RecordProperty("kills_in_writing", kills_in_writing);
  saveMap(first, path("map.h5"));
  EXPECT_FALSE(std::filesystem::exists(path("map.h5.part"))) << "a part that was left is written over";
}

#ifndef __SANITIZE_ADDRESS__  // GCC 12's keeps its allocator's locks in the child of a process with threads; glibc's does not
TEST_F(MapFile, ThreadsSaveAndLoadAtOnce) {
  const MappingParameters parameters = parametersOf(Mode::kOccupancy);
  const MapCopy copy = copyOf(parameters, drawMap(parameters, 3000, 1));
  saveMap(copy, path("map.h5"));
  const auto work = [&](const std::string& own) {
    for (int i = 0; i < 10; ++i) {
      saveMap(copy, path(own));
      EXPECT_EQ(loadMap(path("map.h5")).map.atoms().size(), copy.size());
    }
  };
  std::thread other([&] { work("other.h5"); });
  work("own.h5");
  other.join();
  EXPECT_EQ(contents(path("own.h5")), contents(path("other.h5")));
}
#endif

// A limit on the size of files stands for a full disk.
TEST_F(MapFile, AFullDiskIsReportedAndTheOldMapStays) {
  const MappingParameters parameters = parametersOf(Mode::kOccupancy);
  const MapCopy copy = copyOf(parameters, drawMap(parameters, 5000, 1));
  saveMap(copy, path("map.h5"));
  const std::string before = contents(path("map.h5"));
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{300}, std::size_t{512}, std::size_t{9000}, before.size() - 1}) {
    const rlimit small{size, limit.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    std::string message;
    try {
      saveMap(copy, path("map.h5"));
    } catch (const std::runtime_error& error) {
      message = error.what();
    }
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
    EXPECT_EQ(message, "cannot write " + path("map.h5") + ": File too large");
    EXPECT_EQ(contents(path("map.h5")), before);
    EXPECT_FALSE(std::filesystem::exists(path("map.h5.part")));
  }
}

// A disk of its own that is too small. Only root may make one.
TEST_F(MapFile, ADiskThatIsFullIsReportedAndTheOldMapStays) {
  const std::string disk = path("disk");
  std::filesystem::create_directories(disk);
  if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=192k") != 0) {
    GTEST_SKIP() << "NOT TESTED on a full disk: no right to mount one (" << std::strerror(errno) << ")";
  }
  const MappingParameters parameters = parametersOf(Mode::kOccupancy);
  const MapCopy small = copyOf(parameters, drawMap(parameters, 4000, 1));
  const MapCopy large = copyOf(parameters, drawMap(parameters, 20000, 2));
  const std::string file = disk + "/map.h5";
  saveMap(small, file);
  const std::string before = contents(file);
  std::string message;
  try {
    saveMap(large, file);
  } catch (const std::runtime_error& error) {
    message = error.what();
  }
  const bool is_whole = contents(file) == before && faultOf(file).empty();
  const bool has_part = std::filesystem::exists(file + ".part");
  saveMap(small, file);  // there is room again
  const bool is_saved = contents(file) == before;
  EXPECT_EQ(umount(disk.c_str()), 0);
  EXPECT_EQ(message, "cannot write " + file + ": No space left on device");
  EXPECT_TRUE(is_whole && is_saved);
  EXPECT_FALSE(has_part);
}

TEST_F(MapFile, AFileThatCannotBeWrittenIsNamedWithTheReason) {
  const MappingParameters parameters = parametersOf(Mode::kOccupancy);
  const MapCopy copy = copyOf(parameters, drawMap(parameters, 10, 1));
  for (const auto& [file, reason] :
       {std::pair<std::string, std::string>{path("none/map.h5"), "No such file or directory"},
        {folder_.string(), "Is a directory"},
        {"/proc/map.h5", "No such file or directory"}}) {
    try {
      saveMap(copy, file);
      FAIL() << file;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(error.what(), "cannot write " + file + ": " + reason);
    }
  }
}

}  // namespace
}  // namespace atom_map
