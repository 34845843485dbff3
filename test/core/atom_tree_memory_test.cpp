// What a map of a million atoms costs, by the tree's own count and by the allocator's.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "atom_list.h"
#include "atom_mapping/base/keep_memory.h"
#include "atom_mapping/evaluation/heap_in_use.h"
#include "atom_orders.h"

namespace atom_map {
namespace {

using Eigen::AlignedBox3f;
using Eigen::Vector3f;

constexpr double kSlack = 200e3;  // bytes that the allocator keeps of freed blocks

void insertAll(AtomTree& tree, const Centers& centers) {
  const float values[] = {1.0F, 2.0F};
  for (const Vector3f& center : centers) tree.insert(center, values);
}

// Of the program, as the kernel counts them.
std::size_t residentBytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t all_pages = 0;
  std::size_t resident_pages = 0;
  file >> all_pages >> resident_pages;
  return resident_pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

struct MemoryCase {
  const char* name;
  Centers centers;
};

class AtomTreeMemory : public testing::TestWithParam<MemoryCase> {
 protected:
  // Heap that the tree holds for these atoms, in bytes an atom, and what it says that it holds.
  void expectBytesPerAtom(int value_count, double at_most) const {
    const std::size_t before = heapInUse();
    AtomTree tree(kCell, value_count);
    insertAll(tree, GetParam().centers);
    const auto count = static_cast<double>(tree.size());
    const auto allocated = static_cast<double>(heapInUse() - before);
    EXPECT_NEAR(static_cast<double>(tree.bytes()), allocated, 0.03 * allocated);
    EXPECT_LE(allocated / count, at_most);
    EXPECT_LE(static_cast<double>(tree.bytes()) / count, at_most);
    RecordProperty("bytes_per_atom", std::to_string(allocated / count));
  }
};

TEST_P(AtomTreeMemory, AMillionAtomsOfOccupancyTakeAtMost28BytesEach) {
  expectBytesPerAtom(1, 28.0);
}

TEST_P(AtomTreeMemory, AMillionAtomsOfSignedDistanceTakeAtMost32BytesEach) {
  expectBytesPerAtom(2, 32.0);
}

INSTANTIATE_TEST_SUITE_P(Maps, AtomTreeMemory,
                         testing::Values(MemoryCase{"dense", looseGrid({100, 100, 100}, 1, 1.05F * kDiameter)},
                                         MemoryCase{"loose", looseGrid({100, 100, 100}, 2, 1.6F * kDiameter)},
                                         MemoryCase{"surface", looseGrid({1000, 1000, 1}, 3)},
                                         MemoryCase{"drive", looseGrid({20000, 10, 5}, 4)}),
                         [](const auto& instance) { return instance.param.name; });

TEST(AtomTreeMemoryRemoval, RemovingEveryAtomGivesAllMemoryBack) {
  const Centers centers = looseGrid({40, 40, 40}, 5);
  const std::size_t before = heapInUse();
  AtomTree tree(kCell, 1);
  insertAll(tree, centers);
  const AlignedBox3f everywhere(Vector3f::Constant(-1e3F), Vector3f::Constant(1e3F));
  EXPECT_EQ(tree.removeInBox(everywhere), centers.size());
  EXPECT_EQ(tree.bytes(), 0U);
  EXPECT_NEAR(static_cast<double>(heapInUse()), static_cast<double>(before), kSlack);
}

TEST(AtomTreeMemoryRemoval, RemovingMostAtomsGivesTheirMemoryBack) {
  AtomTree tree(kCell, 1);
  insertAll(tree, looseGrid({40, 40, 40}, 5));
  const std::size_t full = tree.bytes();
  Random random(6);
  while (tree.size() > 6400) {  // by small boxes, which leave every leaf half empty for a while
    const Vector3f middle = drawIn(random, {Vector3f::Zero(), Vector3f::Constant(40.0F * 1.4F * kDiameter)});
    tree.removeInBox({middle - Vector3f::Constant(3.0F), middle + Vector3f::Constant(3.0F)});
  }
  EXPECT_LT(tree.bytes(), full / 3);
}

// What lies far goes, slice by slice, and the memory of its atoms and of its nodes with it.
TEST(AtomTreeMemoryRemoval, ForgettingNineTenthsGivesNineTenthsBack) {
  const Centers centers = looseGrid({100, 100, 100}, 8);
  AtomTree tree(kCell, 1);
  insertAll(tree, centers);
  const auto full = static_cast<double>(tree.bytes());
  const std::size_t heap = heapInUse();
  const Vector3f middle = Vector3f::Constant(70.0F);
  while (tree.removeBeyond(middle, 40.0F, 4096) >= 4096) continue;
  const double share = static_cast<double>(tree.size()) / static_cast<double>(centers.size());
  EXPECT_LT(share, 0.15);
  EXPECT_GT(share, 0.05);
  EXPECT_LT(static_cast<double>(tree.bytes()), 1.2 * share * full);
  const auto given_back = static_cast<double>(heap - heapInUse());
  EXPECT_NEAR(given_back, full - static_cast<double>(tree.bytes()), 0.03 * full);
}

// Not with the address sanitizer, whose allocator keeps it.
#if !defined(__SANITIZE_ADDRESS__)
TEST(AtomTreeMemoryRemoval, WhatIsForgottenGoesBackToTheKernel) {
  keepFreedMemory();  // as the node does, which then asks for it
  FallWatch fall;
  AtomTree tree(kCell, 2);
  insertAll(tree, looseGrid({100, 100, 100}, 8));
  const std::size_t full = tree.bytes();
  EXPECT_FALSE(fall.hasFallenTo(full));
  const std::size_t resident = residentBytes();
  tree.removeBeyond(Vector3f::Constant(70.0F), 30.0F);
  ASSERT_TRUE(fall.hasFallenTo(tree.bytes()));
  EXPECT_FALSE(fall.hasFallenTo(tree.bytes())) << "once is enough";
  returnFreedMemory();
  const auto given_back = static_cast<double>(resident) - static_cast<double>(residentBytes());
  EXPECT_GT(given_back, 0.8 * static_cast<double>(full - tree.bytes()));
}
#endif

// What a map costs at any moment of a drive that sees as much as it forgets.
TEST(AtomTreeMemoryRemoval, ALongStraightDriveInAWindowDoesNotGrow) {
  const Centers drive = looseGrid({20000, 10, 5}, 4);  // 28 km
  constexpr float kWindow = 100.0F;                    // m
  AtomTree tree(kCell, 1);
  std::size_t early = 0;
  std::size_t late = 0;
  std::size_t early_heap = 0;
  std::size_t late_heap = 0;
  const std::size_t before = heapInUse();
  for (std::size_t i = 0; i < drive.size(); ++i) {
    const float value = 1.0F;
    tree.insert(drive[i], &value);
    if (i % 500 == 499) tree.removeBeyond(drive[i], kWindow);
    std::size_t& bytes = i < drive.size() / 5 ? early : late;
    std::size_t& heap = i < drive.size() / 5 ? early_heap : late_heap;
    bytes = std::max(bytes, tree.bytes());
    if (i % 10000 == 0) heap = std::max(heap, heapInUse() - before);
  }
  EXPECT_LE(late, early + early / 20);
  EXPECT_LE(late_heap, early_heap + early_heap / 20 + static_cast<std::size_t>(kSlack));
  EXPECT_LT(tree.size(), 5000U);
}

TEST(AtomTreeMemoryRemoval, BytesNeverPassWhatWasSaidBefore) {
  for (const int value_count : {1, 2}) {
    Random random(9);
    AtomTree tree(kCell, value_count);
    const float values[] = {1.0F, 2.0F};
    for (const Vector3f& center : shuffled(looseGrid({30, 30, 30}, 9), 10)) {
      const std::size_t at_most = tree.bytesAfterInsert();
      tree.insert(center, values);
      ASSERT_LE(tree.bytes(), at_most);
      if (drawIndex(random, 3000) == 0) tree.removeBeyond(center, draw(random, 5.0F, 60.0F));
    }
  }
}

TEST(AtomTreeMemoryRemoval, FillingAndEmptyingOverAndOverDoesNotGrow) {
  const Centers centers = looseGrid({20, 20, 20}, 7);
  AtomTree tree(kCell, 1);
  insertAll(tree, centers);
  const std::size_t once = tree.bytes();
  const AlignedBox3f half(Vector3f::Constant(-1.0F), Vector3f(14.0F, 1e3F, 1e3F));
  for (int i = 0; i < 20; ++i) {
    EXPECT_GT(tree.removeInBox(half), 0U);
    for (const Vector3f& center : centers) {
      const float value = 1.0F;
      if (half.contains(center)) tree.insert(center, &value);
    }
    ASSERT_EQ(tree.size(), centers.size());
  }
  EXPECT_LE(tree.bytes(), once + once / 10);
}

}  // namespace
}  // namespace atom_map
