// The same out of doors, where trees and cars make it harder.
#include <gtest/gtest.h>

#include "drive_coverage.h"

namespace atom_map {
namespace {

TEST(CampusCoverage, ReachesItsFigures) {
  const Drive campus = makeDrive("campus", 40);
  expectCoverage(mapDrive(campus, 0.5).coverage, 0.97, 0.015, 0.97, 0.95);
}

}  // namespace
}  // namespace atom_map
