// What a search costs, loosely: a tree that has become a list fails.
#include <gtest/gtest.h>

#include <chrono>

#include "atom_list.h"
#include "atom_orders.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

AtomTree makeTree(const Centers& centers) {
  return makeTree(numbered(centers, 1), kCell, 1);
}

double secondsToSearch(const AtomTree& tree, const Centers& at) {
  double best = 1e9;
  for (int round = 0; round < 3; ++round) {
    const auto start = std::chrono::steady_clock::now();
    std::size_t found = 0;
    for (const Vector3f& p : at) tree.forEachWithin(p, 1.5F * kDiameter, [&](ConstAtomRef, float) { ++found; });
    EXPECT_GE(found, at.size());
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

// A list would take 100 times as long. 40 leaves room for caches, which the small map fits into and the large does not,
// and for a busy machine.
TEST(AtomTreeCost, ASearchInADriveOfTenKilometresCostsLittleMoreThanInAHundredMetres) {
  const Centers drive = looseGrid({7200, 5, 3}, 4);
  const Centers start(drive.begin(), drive.begin() + static_cast<std::ptrdiff_t>(drive.size() / 100));
  Centers everywhere = shuffled(drive, 8);
  everywhere.resize(20000);
  Centers near;
  while (near.size() < everywhere.size()) near.insert(near.end(), start.begin(), start.end());
  near.resize(everywhere.size());
  EXPECT_LT(secondsToSearch(makeTree(drive), everywhere), 40.0 * secondsToSearch(makeTree(start), near));
}

}  // namespace
}  // namespace atom_map
