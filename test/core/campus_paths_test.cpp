#include <gtest/gtest.h>

#include "drive_paths.h"

namespace atom_map {
namespace {

TEST(CampusPaths, ReachTheirFigures) {
  expectGoodPaths(PathWorld("campus").plan(200, 0.0));
}

}  // namespace
}  // namespace atom_map
