// OctoMap as the baseline feeds it, beside liboctomap fed by hand.
#include "atom_mapping/baseline/octomap_mapper.h"

#include <gtest/gtest.h>

#include "atom_mapping/evaluation/heap_in_use.h"
#include "atom_mapping/map/mapper.h"
#include "atom_mapping/sim/coverage.h"
#include "draw.h"
#include "simulated.h"

namespace atom_map {
namespace {

using Eigen::Vector3d;

octomap::point3d toOctomap(const Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

// What liboctomap says of a point.
Occupancy askTree(const octomap::OcTree& tree, const Vector3d& point) {
  const octomap::OcTreeNode* const node = tree.search(toOctomap(point));
  if (node == nullptr) return Occupancy::kUnknown;
  return tree.isNodeOccupied(node) ? Occupancy::kOccupied : Occupancy::kFree;
}

void expectSameAnswers(const OctomapMapper& mapper, const octomap::OcTree& tree, const Vector3d& center) {
  Random random(1);
  std::array<int, 3> counts{};
  for (int i = 0; i < 20000; ++i) {
    const Vector3d point = center + drawWithin(random, 15.0F).cast<double>();
    const Occupancy answer = mapper.read([&](const OctomapBaseline& map) { return map.classify(point); });
    ASSERT_EQ(answer, askTree(tree, point)) << point.transpose();
    ++counts[static_cast<std::size_t>(answer)];
  }
  for (const int count : counts) EXPECT_GT(count, 100);
}

TEST(OctomapMapper, VoxelsHoldAsMuchAsAtoms) {
  const double radius = 0.3;
  EXPECT_NEAR(std::pow(equalVolumeVoxel(radius), 3), 4.0 / 3.0 * M_PI * std::pow(radius, 3), 1e-12);
  MappingParameters parameters;
  parameters.radius = radius;
  const OctomapMapper by_radius(parameters, {});
  EXPECT_EQ(by_radius.read([](const auto& map) { return map.tree().getResolution(); }), equalVolumeVoxel(radius));
  const OctomapMapper by_resolution(parameters, {0.7, false});
  EXPECT_EQ(by_resolution.read([](const auto& map) { return map.tree().getResolution(); }), 0.7);
  EXPECT_EQ(by_resolution.read([](const auto& map) { return map.tree().getTreeDepth(); }), 16U);
}

TEST(OctomapMapper, AnswersAreLiboctomapsOwn) {
  const Drive drive = makeDrive("hall", 3);
  MappingParameters parameters;
  parameters.scan.thinning = 0.0;
  OctomapMapper mapper(parameters, {});
  octomap::OcTree tree(equalVolumeVoxel(parameters.radius));
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    mapper.insertScan(drive.scans[i], drive.poses[i]);
    octomap::Pointcloud cloud;
    for (const Eigen::Vector3f& point : drive.scans[i].points) {
      if (isInRange(point, parameters.scan)) cloud.push_back(toOctomap(drive.poses[i] * point.cast<double>()));
    }
    tree.insertPointCloud(cloud, toOctomap(drive.poses[i].translation()), -1.0, true);
  }
  expectSameAnswers(mapper, tree, drive.poses[0].translation());
  mapper.read([&](const OctomapBaseline& map) { EXPECT_EQ(map.tree().size(), tree.size()); });
}

TEST(OctomapMapper, PruningChangesTheSizeAndNoAnswer) {
  const Drive drive = makeDrive("hall", 3);
  OctomapMapper plain({}, {});
  OctomapMapper pruned({}, {0.0, true});
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    plain.insertScan(drive.scans[i], drive.poses[i]);
    pruned.insertScan(drive.scans[i], drive.poses[i]);
  }
  const auto size = [](const OctomapBaseline& map) { return map.tree().size(); };
  EXPECT_LT(pruned.read(size), plain.read(size));
  plain.read([&](const OctomapBaseline& map) { expectSameAnswers(pruned, map.tree(), drive.poses[0].translation()); });
}

TEST(OctomapMapper, UsesTheReturnsThatTheAtomMapUses) {
  const Drive drive = makeDrive("hall", 3);
  Mapper atoms{MappingParameters()};
  OctomapMapper voxels({}, {});
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    const FilterReport ours = atoms.insertScan(drive.scans[i], drive.poses[i]).filter;
    const ScanReport report = voxels.insertScan(drive.scans[i], drive.poses[i]);
    EXPECT_EQ(report.filter.points_in, ours.points_in);
    EXPECT_EQ(report.filter.thinned, ours.thinned);
    EXPECT_EQ(report.filter.too_far, ours.too_far);
    EXPECT_EQ(report.surface_points, ours.points_in - ours.thinned - ours.too_far - ours.too_near);
    EXPECT_GT(report.seconds.filter * report.seconds.merge, 0.0);
  }
}

TEST(OctomapMapper, RaysWithoutAnEchoFreeTheirSpaceIfAsked) {
  LidarScan scan;
  scan.no_returns = {Eigen::Vector3f::UnitX()};
  MappingParameters parameters;
  const auto freed = [&](double range) {
    OctomapMapper mapper(parameters, {});
    mapper.insertScan(scan, Pose::Identity());
    return mapper.read([&](const OctomapBaseline& map) { return map.classify({range, 0.0, 0.0}); });
  };
  EXPECT_EQ(freed(10.0), Occupancy::kUnknown);
  parameters.scan.clear_no_returns = true;
  EXPECT_EQ(freed(10.0), Occupancy::kFree);
  EXPECT_EQ(freed(24.0), Occupancy::kFree);
  EXPECT_EQ(freed(26.0), Occupancy::kUnknown);
}

TEST(OctomapMapper, WhatLiesOutsideTheTreeIsLeftOut) {
  OctomapBaseline map(0.01);  // reaches to 327 m
  const std::vector<Eigen::Vector3f> returns{{5.0F, 0.0F, 0.0F}, {-5.0F, 0.0F, 0.0F}};
  const auto at = [](double x) { return Pose(Eigen::Translation3d(x, 0.0, 0.0)); };
  EXPECT_EQ(map.insertScan(returns, at(324.0)), 1U);
  EXPECT_EQ(map.classify({319.0, 0.0, 0.0}), Occupancy::kOccupied);
  EXPECT_EQ(map.insertScan(returns, at(1e6)), 0U);
  EXPECT_EQ(map.classify({1e6, 0.0, 0.0}), Occupancy::kUnknown);
}

TEST(OctomapMapper, ResetEmptiesItAndStartsTheDrawsAnew) {
  const Drive drive = makeDrive("hall", 1);
  OctomapMapper mapper({}, {});
  const auto size = [](const OctomapBaseline& map) { return map.tree().size(); };
  mapper.insertScan(drive.scans[0], drive.poses[0]);
  const std::size_t first = mapper.read(size);
  mapper.reset();
  EXPECT_EQ(mapper.read(size), 0U);
  mapper.insertScan(drive.scans[0], drive.poses[0]);
  EXPECT_EQ(mapper.read(size), first);
}

#if !defined(__SANITIZE_ADDRESS__)  // which counts what is asked for, and no more
TEST(OctomapMapper, BytesAreThoseOfTheAllocator) {
  const Drive drive = makeDrive("hall", 3);
  for (const bool prune : {false, true}) {
    OctomapMapper mapper({}, {0.0, prune});
    for (std::size_t i = 0; i < drive.scans.size(); ++i) mapper.insertScan(drive.scans[i], drive.poses[i]);
    const auto counted = mapper.read([](const OctomapBaseline& map) { return map.bytes(); });
    const std::size_t released = heapReleasedBy([&] { mapper.reset(); });
    EXPECT_NEAR(static_cast<double>(counted), static_cast<double>(released), 0.005 * static_cast<double>(released));
  }
}
#endif

}  // namespace
}  // namespace atom_map
