// Who reads the map may hold a scan up for as long as one reading takes, and no longer.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "atom_mapping/map/mapper.h"

namespace atom_map {
namespace {

using Clock = std::chrono::steady_clock;

// There is one reading at every moment, since each lasts long and another begins at once.
TEST(MapperReaders, ThatRelieveOneAnotherLetScansIn) {
  constexpr std::uint32_t kScans = 20;
  constexpr int kReaders = 4;
  constexpr auto kReading = std::chrono::milliseconds(1);
  const auto give_up = Clock::now() + std::chrono::seconds(20);
  Mapper mapper((MappingParameters()));
  std::atomic<std::uint32_t> merged{0};
  std::atomic<int> begun{0};
  std::vector<std::thread> readers;
  for (int i = 0; i < kReaders; ++i) {
    readers.emplace_back([&] {
      ++begun;
      while (merged < kScans && Clock::now() < give_up) {
        mapper.read([&](const AtomMap&) { std::this_thread::sleep_for(kReading); });
      }
    });
  }
  while (begun < kReaders) std::this_thread::yield();
  while (merged < kScans && Clock::now() < give_up) {
    const float y = 0.1F * static_cast<float>(merged);
    mapper.insertScan({{{5.0F, y, 0.0F}, {5.0F, y, 1.0F}}, {}}, Pose::Identity());
    if (Clock::now() < give_up) ++merged;
  }
  for (std::thread& reader : readers) reader.join();
  EXPECT_EQ(merged, kScans);
}

}  // namespace
}  // namespace atom_map
