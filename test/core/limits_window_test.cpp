// A map with a window is the whole map's part about the sensor, however far that drives.
#include <algorithm>
#include <array>

#include "atom_mapping/base/check_parameters.h"
#include "limited_drive.h"

namespace atom_map {
namespace {

TEST_P(Limits, AWindowKeepsWhatTheWholeMapHasThereAndNothingBeyond) {
  parameters_.limits.window = kRange + 4.0 * parameters_.radius + parameters_.rays.normal_distance;
  Mapper windowed(parameters_);
  MappingParameters without = parameters_;
  without.limits = {};
  Mapper whole(without);
  std::uint64_t forgotten = 0;
  drive(windowed, [&](std::size_t scan, const ScanReport& report, const Atoms&) {
    whole.insertScan(corridor().scans[scan], corridor().poses[scan]);
    forgotten += report.forgotten;
    const Atoms kept = atomsOf(windowed);
    const Atoms all = atomsOf(whole);
    for (const auto& [center, values] : kept) {
      ASSERT_LE(distance(windowed, center, scan), (1.0 + kWindowSlack) * parameters_.limits.window + 1e-3);
      ASSERT_EQ(all.at(center), values);
    }
    for (const auto& atom : all) {
      const bool is_in = distance(windowed, atom.first, scan) < parameters_.limits.window - 1e-3;
      ASSERT_TRUE(!is_in || kept.count(atom.first) == 1);
    }
  });
  EXPECT_EQ(forgotten, atomsOf(whole).size() - atomsOf(windowed).size());
  EXPECT_GT(forgotten, 1000U);
}

TEST_P(Limits, AWindowKeepsMemoryConstantOnALongDrive) {
  parameters_.limits.window = kRange;
  Mapper mapper(parameters_);
  std::array<std::uint64_t, 2> most{};  // bytes, in the second and the last quarter
  drive(mapper, [&](std::size_t scan, const ScanReport& report, const Atoms&) {
    if (scan / 10 == 1) most[0] = std::max(most[0], report.map_bytes);
    if (scan / 10 == 3) most[1] = std::max(most[1], report.map_bytes);
  });
  EXPECT_LE(static_cast<double>(most[1]), 1.1 * static_cast<double>(most[0]));
}

INSTANTIATE_TEST_SUITE_P(ModesAndSeeds, Limits, modesAndSeeds(), nameOf);

TEST(LimitFaults, AWindowThatRaysReachBeyondIsNamedWithTheRemedy) {
  MappingParameters parameters;
  parameters.limits.window = 10.0;
  const std::vector<std::string> faults = findFaults(parameters);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0],
            "limits/window is 10; it must be 0 or at least scan/max_range, which is 25: lower that for a "
            "smaller window");
  parameters.scan.max_range = 10.0;
  EXPECT_TRUE(findFaults(parameters).empty());
}

}  // namespace
}  // namespace atom_map
