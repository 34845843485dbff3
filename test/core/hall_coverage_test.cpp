// The figures of the issue: 40 scans of the hall with 2 cm of noise.
#include <gtest/gtest.h>

#include "drive_coverage.h"

namespace atom_map {
namespace {

TEST(HallCoverage, ReachesItsFigures) {
  const Drive hall = makeDrive("hall", 40);
  const Result coarse = mapDrive(hall, 0.5);
  expectCoverage(coarse.coverage, 0.97, 0.015, 0.97, 0.97);
  EXPECT_LE(coarse.bytes, 28 * coarse.atoms);
  const Result fine = mapDrive(hall, 0.25);
  expectCoverage(fine.coverage, 0.98, 0.01, 0.97, 0.97);
  EXPECT_LE(fine.bytes, 28 * fine.atoms);
}

}  // namespace
}  // namespace atom_map
