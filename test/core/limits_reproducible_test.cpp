// What a map with limits holds follows from its scans alone: the same ones give the same bytes, whatever stopped in between,
// and a limit out of reach changes none.
#include <array>
#include <utility>

#include "limited_drive.h"

namespace atom_map {
namespace {

TEST_P(Limits, ALimitThatIsNotReachedChangesNothing) {
  Mapper unlimited(parameters_);
  drive(unlimited, [](auto&&...) {});
  for (const LimitPolicy policy : {LimitPolicy::kRefuse, LimitPolicy::kForgetFarthest}) {
    parameters_.limits = {static_cast<std::uint32_t>(atomsOf(unlimited).size()), 1000.0, policy, 1000.0};
    Mapper mapper(parameters_);
    drive(mapper, [](std::size_t, const ScanReport& report, const Atoms&) {
      EXPECT_EQ(report.merge.refused + report.forgotten, 0U);
    });
    EXPECT_EQ(bytesOf(mapper), bytesOf(unlimited));
  }
}

TEST_P(Limits, TheSameScansGiveTheSameBytesAndResetStartsAnew) {
  parameters_.limits = {1500, 0.0, LimitPolicy::kForgetFarthest, 14.0};
  Mapper first(parameters_);
  Mapper second(parameters_);
  drive(first, [](auto&&...) {});
  drive(second, [](auto&&...) {});
  EXPECT_FALSE(bytesOf(first).empty());
  EXPECT_EQ(bytesOf(first), bytesOf(second));
  second.reset();
  drive(second, [](auto&&...) {});
  EXPECT_EQ(bytesOf(first), bytesOf(second));
}

// As after a map file, which holds the atoms in their order and what the last scan tells the next.
TEST_P(Limits, AMapThatIsMadeAnewOfItsAtomsGoesOnAsIfItHadNeverStopped) {
  parameters_.limits = {1500, 0.0, LimitPolicy::kForgetFarthest, 14.0};
  Mapper whole(parameters_);
  Mapper stopped(parameters_);
  drive(whole, [&](std::size_t scan, const ScanReport&, const Atoms&) {
    stopped.insertScan(corridor().scans[scan], corridor().poses[scan]);
    AtomMap anew(parameters_.mode, parameters_.radius);
    stopped.read([&](const AtomMap& map) {
      anew.anchor(map.origin());
      anew.planes() = map.planes();
      map.atoms().forEach([&](ConstAtomRef atom) {
        const std::array<float, 2> values{atom.value(), map.mode() == Mode::kOccupancy ? 0.0F : atom.value(1)};
        anew.atoms().insert(atom.center(), values.data());
      });
    });
    stopped.replace(std::move(anew), scan + 1);
    ASSERT_EQ(bytesOf(stopped), bytesOf(whole));
  });
}

INSTANTIATE_TEST_SUITE_P(ModesAndSeeds, Limits, modesAndSeeds(), nameOf);

}  // namespace
}  // namespace atom_map
