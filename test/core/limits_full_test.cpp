// A full map keeps within its limit after every scan: it refuses new atoms, or forgets the farthest and no more than it must.
#include <algorithm>

#include "limited_drive.h"

namespace atom_map {
namespace {

TEST_P(Limits, AFullMapRefusesNewAtomsAndKeepsTheOthersUpToDate) {
  const std::size_t all = unlimitedSize();
  for (const bool by_bytes : {false, true}) {
    parameters_.limits = {};
    if (!by_bytes) parameters_.limits.max_atoms = static_cast<std::uint32_t>(all / 2);
    if (by_bytes) parameters_.limits.max_megabytes = 12e-6 * static_cast<double>(all);
    Mapper mapper(parameters_);
    std::uint64_t refused = 0;
    std::size_t updates_when_full = 0;
    drive(mapper, [&](std::size_t, const ScanReport& report, const Atoms& before) {
      expectHeld(mapper);
      const Atoms after = atomsOf(mapper);
      EXPECT_EQ(after.size(), before.size() + report.merge.inserted);
      for (const auto& atom : before) ASSERT_EQ(after.count(atom.first), 1U) << "a map that refuses removes nothing";
      if (report.merge.inserted == 0) updates_when_full += after != before ? 1 : 0;
      refused += report.merge.refused;
      EXPECT_EQ(report.forgotten, 0U);
    });
    EXPECT_GT(refused, all / 10);
    EXPECT_GE(updates_when_full, 1U);
    EXPECT_GT(atomsOf(mapper).size(), all / 4);
  }
}

TEST_P(Limits, AForgetfulMapForgetsTheFarthestAndNoMoreThanItMust) {
  const std::size_t all = unlimitedSize();
  for (const bool by_bytes : {false, true}) {
    parameters_.limits = {};
    parameters_.limits.policy = LimitPolicy::kForgetFarthest;
    if (!by_bytes) parameters_.limits.max_atoms = static_cast<std::uint32_t>(all / 3);
    if (by_bytes) parameters_.limits.max_megabytes = 10e-6 * static_cast<double>(all);
    Mapper mapper(parameters_);
    std::size_t least = all;
    int scans_that_forgot = 0;
    drive(mapper, [&](std::size_t scan, const ScanReport& report, const Atoms& before) {
      expectHeld(mapper);
      EXPECT_EQ(report.merge.refused, 0U);
      const Atoms after = atomsOf(mapper);
      EXPECT_EQ(after.size(), before.size() + report.merge.inserted - report.forgotten);
      if (report.forgotten == 0) return;
      ++scans_that_forgot;
      least = std::min(least, after.size());
      double farthest_kept = 0.0;
      for (const auto& atom : after) farthest_kept = std::max(farthest_kept, distance(mapper, atom.first, scan));
      for (const auto& atom : before) {
        ASSERT_TRUE(after.count(atom.first) == 1 || distance(mapper, atom.first, scan) >= farthest_kept - 1e-4);
      }
    });
    EXPECT_GT(scans_that_forgot, 3);
    EXPECT_LT(scans_that_forgot, kScans) << "each scan that forgets makes room for some";
    EXPECT_GE(least, by_bytes ? all / 5 : all / 3 * 94 / 100);
  }
}

INSTANTIATE_TEST_SUITE_P(ModesAndSeeds, Limits, modesAndSeeds(), nameOf);

}  // namespace
}  // namespace atom_map
