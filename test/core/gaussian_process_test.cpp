// Equations (6) to (8): the regression against its textbook form, its gradient against differences, and the neighbours
// that could make it unstable.
#include "atom_mapping/query/gaussian_process.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>

#include "draw.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

constexpr float kRadius = 0.25F;

struct Expected {
  double value;
  double variance;
};

// All atoms, sorted, by matrices and their inverse.
Expected byTheBook(const AtomMap& map, const GaussianProcessParameters& p, const Vector3f& query) {
  std::vector<Neighbor> atoms;
  map.atoms().kNearest(query, map.atoms().size(), 1e3F, atoms);
  atoms.resize(std::min<std::size_t>(atoms.size(), p.neighbors));
  while (atoms.back().squared_distance >= 16.0F * kRadius * kRadius) atoms.pop_back();
  const bool distances = map.mode() == Mode::kSignedDistance;
  const double r = kRadius;
  const double alpha = (distances ? p.distance_alpha : p.alpha) / (r * r);
  const auto n = static_cast<Eigen::Index>(atoms.size());
  Eigen::MatrixXd sigma(n, n);
  Eigen::VectorXd k(n);
  Eigen::VectorXd y(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Neighbor& a = atoms[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < n; ++j) {
      const Vector3f apart = a.center - atoms[static_cast<std::size_t>(j)].center;
      sigma(i, j) = std::exp(-alpha * apart.squaredNorm());
    }
    sigma(i, i) += distances ? p.distance_noise + p.atom_variance_share * a.values[1] / (r * r) : p.noise_variance;
    k[i] = std::exp(-alpha * (a.center - query).squaredNorm());
    y[i] = a.values[0];
  }
  const double mean = distances ? y.mean() : 0.0;
  const Eigen::MatrixXd inverse = sigma.inverse();
  const double unit = distances ? r : 1.0;
  return {mean + k.dot(inverse * (y.array() - mean).matrix()), unit * unit * (1.0 - k.dot(inverse * k))};
}

AtomMap drawMap(Mode mode, Random& random, int atoms, float half) {
  AtomMap map(mode, kRadius);
  for (int i = 0; i < atoms; ++i) {
    const std::array<float, 2> values{draw(random, -1.0F, 1.0F), draw(random, 0.001F, 0.1F)};
    map.atoms().insert(drawWithin(random, half), values.data());
  }
  return map;
}

class GaussianProcessOf : public testing::TestWithParam<std::tuple<Mode, int>> {};

TEST_P(GaussianProcessOf, RandomAtomsIsWhatTheEquationsGive) {
  const auto [mode, seed] = GetParam();
  Random random(static_cast<std::uint64_t>(seed));
  const AtomMap map = drawMap(mode, random, 60, 0.8F);
  const GaussianProcessParameters parameters;
  GaussianProcess process(map, parameters);
  for (int i = 0; i < 20; ++i) {
    const Vector3f query = drawWithin(random, 0.7F);
    const auto estimate = process.estimate(query);
    ASSERT_EQ(estimate.has_value(), map.atoms().nearest(query, 2.0F * kRadius).has_value());
    if (!estimate) continue;
    const Expected expected = byTheBook(map, parameters, query);
    EXPECT_NEAR(estimate->value, expected.value, 1e-4);
    EXPECT_NEAR(estimate->variance, expected.variance, 1e-4);
  }
}

TEST_P(GaussianProcessOf, RandomAtomsHasTheGradientOfItsValue) {
  const auto [mode, seed] = GetParam();
  Random random(static_cast<std::uint64_t>(seed));
  const AtomMap map = drawMap(mode, random, 15, 0.5F);  // fewer than N, so that the same atoms answer nearby
  GaussianProcess process(map, GaussianProcessParameters{});
  constexpr float kStep = 0.01F;
  for (int i = 0; i < 10; ++i) {
    const Vector3f query = drawWithin(random, 0.2F);
    const auto estimate = process.estimate(query);
    ASSERT_TRUE(estimate);
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3f step = kStep * Vector3f::Unit(axis);
      const float difference = process.estimate(query + step)->value - process.estimate(query - step)->value;
      EXPECT_NEAR(estimate->gradient[axis], difference / (2.0F * kStep), 2e-2F);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, GaussianProcessOf,
                         testing::Combine(testing::Values(Mode::kOccupancy, Mode::kSignedDistance),
                                          testing::Range(1, 21)));

TEST(GaussianProcess, ReproducesAPlaneFromAtomsOnBothSides) {
  AtomMap map(Mode::kSignedDistance, kRadius);
  for (int x = -6; x <= 6; ++x) {
    for (int y = -6; y <= 6; ++y) {
      for (const float z : {-0.25F, 0.25F, 0.75F}) {
        const std::array<float, 2> values{z, 1e-3F};
        map.atoms().insert({0.5F * static_cast<float>(x), 0.5F * static_cast<float>(y), z}, values.data());
      }
    }
  }
  GaussianProcess process(map, GaussianProcessParameters{});
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vector3f query(draw(random, -1.5F, 1.5F), draw(random, -1.5F, 1.5F), draw(random, -0.3F, 0.6F));
    const auto estimate = process.estimate(query);
    ASSERT_TRUE(estimate);
    EXPECT_NEAR(estimate->value, query.z(), 0.05F * kRadius);
    EXPECT_NEAR((estimate->gradient - Vector3f::UnitZ()).norm(), 0.0F, 0.1F);
  }
}

TEST(GaussianProcess, BearsCoincidentAndClusteredNeighbours) {
  for (const Mode mode : {Mode::kOccupancy, Mode::kSignedDistance}) {
    AtomMap map(mode, kRadius);
    for (int i = 0; i < 64; ++i) {
      const std::array<float, 2> values{0.4F, 1e-6F};
      map.atoms().insert({1e-6F * static_cast<float>(i % 3), 0.0F, 0.0F}, values.data());
    }
    GaussianProcessParameters parameters;
    parameters.neighbors = 64;
    GaussianProcess process(map, parameters);
    const auto estimate = process.estimate({0.01F, 0.0F, 0.0F});
    ASSERT_TRUE(estimate);
    EXPECT_NEAR(estimate->value, 0.4F, 0.01F);
    EXPECT_TRUE(estimate->gradient.allFinite());
    EXPECT_GE(estimate->variance, 0.0F);
  }
}

TEST(GaussianProcess, KnowsNothingBeyondTwoRadiiUnlessToldSo) {
  AtomMap map(Mode::kOccupancy, kRadius);
  const float log_odds = 1.0F;
  map.atoms().insert(Vector3f::Zero(), &log_odds);
  GaussianProcess process(map, GaussianProcessParameters{});
  EXPECT_TRUE(process.estimate({1.99F * kRadius, 0.0F, 0.0F}));
  EXPECT_FALSE(process.estimate({2.01F * kRadius, 0.0F, 0.0F}));
  EXPECT_TRUE(process.estimate({2.99F * kRadius, 0.0F, 0.0F}, 3.0F));
  EXPECT_FALSE(process.estimate({3.01F * kRadius, 0.0F, 0.0F}, 3.0F));
  const AtomMap empty(Mode::kOccupancy, kRadius);
  EXPECT_FALSE(GaussianProcess(empty, GaussianProcessParameters{}).estimate(Vector3f::Zero()));
}

}  // namespace
}  // namespace atom_map
