#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "atom_mapping/io/picture/find_ceiling.h"
#include "atom_mapping/io/picture/light_atoms.h"

namespace {

constexpr float kRadius = 0.25F;
const Eigen::Vector3f kZenith = Eigen::Vector3f::UnitZ();

// Atoms side by side at one height, over a square around the origin.
std::vector<Eigen::Vector3f> level(float height, float half_side) {
  std::vector<Eigen::Vector3f> centers;
  for (float x = -half_side; x <= half_side; x += 2.0F * kRadius) {
    for (float y = -half_side; y <= half_side; y += 2.0F * kRadius) centers.emplace_back(x, y, height);
  }
  return centers;
}

std::vector<Eigen::Vector3f> joined(std::vector<Eigen::Vector3f> a, const std::vector<Eigen::Vector3f>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(FindCeiling, findsTheUnderside) {
  const auto ceiling = atom_map::findCeiling(joined(level(0.0F, 10.0F), level(4.0F, 10.0F)), kRadius);
  ASSERT_TRUE(ceiling.has_value());
  EXPECT_LT(*ceiling, 4.0F);
  EXPECT_GT(*ceiling, 4.0F - 5.0F * kRadius);
}

TEST(FindCeiling, openGroundHasNone) {
  EXPECT_FALSE(atom_map::findCeiling(level(0.0F, 10.0F), kRadius).has_value());
  EXPECT_FALSE(atom_map::findCeiling({Eigen::Vector3f::Zero()}, kRadius).has_value());
}

TEST(FindCeiling, aRoofOverASmallPartIsNone) {
  EXPECT_FALSE(atom_map::findCeiling(joined(level(0.0F, 10.0F), level(4.0F, 3.0F)), kRadius).has_value());
}

TEST(FindCeiling, aMapFarTallerThanWideTakesNoTime) {
  std::vector<Eigen::Vector3f> centers = level(0.0F, 10.0F);
  centers.emplace_back(0.0F, 0.0F, 1e6F);
  EXPECT_FALSE(atom_map::findCeiling(centers, kRadius).has_value());
}

TEST(LightAtoms, openGroundIsLit) {
  const auto centers = level(0.0F, 5.0F);
  for (const float light : atom_map::lightAtoms(centers, kRadius, kZenith)) EXPECT_GT(light, 0.8F);
}

TEST(LightAtoms, aRoofCastsShade) {
  const auto ground = level(0.0F, 10.0F);
  const auto light = atom_map::lightAtoms(joined(ground, level(3.0F, 4.0F)), kRadius, kZenith);
  for (std::size_t i = 0; i < ground.size(); ++i) {
    if (ground[i].cwiseAbs().maxCoeff() < 2.0F) {
      EXPECT_LT(light[i], 0.5F) << ground[i].transpose();
    } else if (ground[i].cwiseAbs().minCoeff() > 9.0F) {
      EXPECT_GT(light[i], 0.8F) << ground[i].transpose();
    }
  }
}

TEST(LightAtoms, bearsOneAtomAndFarOnes) {
  EXPECT_EQ(atom_map::lightAtoms({Eigen::Vector3f::Zero()}, kRadius, kZenith).size(), 1U);
  EXPECT_EQ(atom_map::lightAtoms({Eigen::Vector3f::Zero(), Eigen::Vector3f::Constant(5e4F)}, kRadius, kZenith).size(),
            2U);
  EXPECT_EQ(atom_map::lightAtoms({Eigen::Vector3f::Zero(), {1e6F, 0.0F, 0.0F}}, 1e-3F, kZenith).size(), 2U);
}

}  // namespace
