// Stage 2: normals against exact ones.
#include "atom_mapping/scan/normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "draw.h"
#include "normal_errors.h"
#include "simulated.h"

namespace atom_map {
namespace {

// Of the k-th ray of a filtered scan; sensor frame.
Eigen::Vector3f trueNormalAt(const SimulatedScan& scan, const FilteredScan& filtered, std::size_t k) {
  return scan.returns.at(filtered.rays[k]).true_normal;
}

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

// What a scan learns of flat surfaces serves the next one: fewer fits, and truer normals. On curved ones it does no harm.
TEST(Normals, OfADriveGrowTruerByWhatTheScanBeforeTold) {
  for (const char* scene : {"hall", "campus", "cube_rotated", "sphere"}) {
    const Drive drive = makeDrive(scene, 15);
    const double radius = 0.25;
    ScanParameters parameters;
    parameters.min_range = 0.0;  // so that all returns stay, and keep their places
    std::vector<KnownPlane> known;
    NormalReport report;
    NormalReport report_of_forgetful;
    Errors errors;
    Errors errors_of_forgetful;
    Random random(3);
    for (std::size_t i = 0; i < drive.scans.size(); ++i) {
      const Eigen::Isometry3f pose(drive.poses[i].matrix().cast<float>());
      const FilteredScan filtered = filterScan(drive.scans[i], radius, parameters, random);
      ASSERT_EQ(filtered.points.size(), drive.simulated[i].returns.size());
      const auto add_errors = [&](std::vector<KnownPlane>& told, NormalReport& to, Errors& all) {
        const std::vector<SurfacePoint> surface = estimateSurface(filtered, pose, radius, parameters, told, to);
        for (std::size_t k = 0; k < surface.size(); ++k) {
          const Eigen::Vector3f true_normal = pose.linear() * trueNormalAt(drive.simulated[i], filtered, k);
          all.all.push_back(std::acos(std::clamp(surface[k].normal.dot(true_normal), -1.0F, 1.0F)) * 180.0 / M_PI);
        }
      };
      add_errors(known, report, errors);
      std::vector<KnownPlane> nothing;
      add_errors(nothing, report_of_forgetful, errors_of_forgetful);
    }
    const auto returns = static_cast<double>(errors.all.size());
    const double fits = 1.0 - report.shared / returns;
    const double fits_of_forgetful = 1.0 - report_of_forgetful.shared / returns;
    std::printf("%-12s fits %.3f -> %.3f of returns, median %.2f -> %.2f deg, 95 %% %.2f -> %.2f\n", scene,
                fits_of_forgetful, fits, errors_of_forgetful.quantile(0.5), errors.quantile(0.5),
                errors_of_forgetful.quantile(0.95), errors.quantile(0.95));
    EXPECT_LE(fits, (std::string(scene) == "sphere" ? 1.0 : 0.7) * fits_of_forgetful) << scene;
    EXPECT_LE(errors.quantile(0.5), 1.05 * errors_of_forgetful.quantile(0.5)) << scene;
    EXPECT_LE(errors.quantile(0.95), 1.05 * errors_of_forgetful.quantile(0.95)) << scene;
  }
}

}  // namespace
}  // namespace atom_map
