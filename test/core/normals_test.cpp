// Stage 2: normals against exact ones.
#include "atom_mapping/scan/normals.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <string>

#include "draw.h"
#include "normal_errors.h"
#include "simulated.h"

namespace atom_map {
namespace {

TEST(Normals, OfTheHallAreWithinFiveDegreesAndHardlyEverOverThirty) {
  const Drive drive = makeDrive("hall", 6, 7);
  std::map<std::string, Errors> errors;
  NormalReport report;
  for (const SimulatedScan& scan : drive.simulated) {
    for (const Estimate& estimate : estimate(scan, report)) {
      const int range = static_cast<int>(estimate.truth->true_point.norm() / 5.0F) * 5;
      char label[32];
      std::snprintf(label, sizeof label, "range %02d to %02d m", range, range + 5);
      for (const std::string& group : {std::string("all"), toString(estimate.truth->kind), std::string(label)}) {
        errors[group].all.push_back(estimate.error);
      }
    }
  }
  std::printf("%-18s %8s %8s %8s %9s\n", "normals of hall", "points", "median", "90 %", "over 30");
  for (auto& [group, of_group] : errors) {
    std::printf("%-18s %8zu %7.2f° %7.2f° %7.2f %%\n", group.c_str(), of_group.all.size(), of_group.quantile(0.5),
                of_group.quantile(0.9), 100.0 * of_group.shareOver(30.0));
  }
  const auto points = static_cast<double>(errors.at("all").all.size());
  std::printf("from a line %.2f %%, from the ray %.2f %%\n", 100.0 * report.from_line / points,
              100.0 * report.from_ray / points);
  EXPECT_LE(errors.at("all").quantile(0.5), 5.0);
  EXPECT_LE(errors.at("all").shareOver(30.0), 0.05);
  for (const char* kind : {"ground", "wall", "box"}) EXPECT_LE(errors.at(kind).quantile(0.5), 5.0) << kind;
  EXPECT_LE(errors.at("column").quantile(0.5), 8.0);
}

TEST(Normals, OfExactPlanesAreExact) {
  LidarModel model;
  model.noise_sigma = 0.0;
  Random random(2);
  std::size_t points = 0;
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector3d up = drawDirection(random).cast<double>().normalized();
    const ConvexPolyhedron beneath({Plane(up, static_cast<double>(draw(random, 1.0F, 8.0F)))});
    const SimulatedScan scan = scanFromOrigin({{beneath, SurfaceKind::kGround}}, model);
    for (const double noise : {0.02, 0.0}) {  // as the sensor's maker states it
      NormalReport report;
      for (const Estimate& estimate : estimate(scan, report, noise)) {
        ASSERT_LE(estimate.error, 0.05) << "at " << estimate.truth->true_point.transpose();
        ++points;
      }
      EXPECT_EQ(report.from_line + report.from_ray, 0U);
    }
  }
  EXPECT_GT(points, 100000U);
}

TEST(Normals, OfColumnsFollowTheirCurve) {
  for (const double radius : {0.3, 0.45, 1.0}) {
    for (const double distance : {3.0, 6.0, 12.0}) {
      const SimulatedScan scan = scanFromOrigin({makeRoom(15.0), makeUprightPole(distance, 0.0, radius)}, LidarModel{});
      NormalReport report;
      Errors errors;
      for (const Estimate& estimate : estimate(scan, report)) {
        if (estimate.truth->kind == SurfaceKind::kPole) errors.all.push_back(estimate.error);
      }
      ASSERT_GT(errors.all.size(), 100U);
      EXPECT_LE(errors.quantile(0.5), 10.0) << radius << " m at " << distance << " m";
      EXPECT_LE(errors.shareOver(30.0), 0.05) << radius << " m at " << distance << " m";
    }
  }
}

// Where rings lie farther apart than things are large, the edge between two planes is no plane of its own.
TEST(Normals, OfARoomKeepToTheirOwnWallUpToItsEdges) {
  for (const double yaw : {0.0, 0.3, 0.7}) {
    NormalReport report;
    Errors errors;
    for (const Estimate& estimate : estimate(scanFromOrigin({makeRoom(4.0, yaw)}, LidarModel{}), report)) {
      errors.all.push_back(estimate.error);
    }
    EXPECT_LE(errors.quantile(0.5), 2.0);
    EXPECT_LE(errors.shareOver(10.0), 0.02);
  }
}

}  // namespace
}  // namespace atom_map
