#include "atom_mapping/query/gaussian_process.h"

#include <Eigen/Cholesky>

namespace atom_map {
namespace {

constexpr int kMaxNeighbors = 64;  // the range of gaussian_process/neighbors
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxNeighbors, 1>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxNeighbors, kMaxNeighbors>;
using Offsets = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMaxNeighbors>;

// What differs between the modes.
struct Kernel {
  double alpha;           // per square metre
  double noise_variance;  // sigma_n^2, in squared units
  double unit;            // of the values, so that the kernel's variance of 1 fits them
  double variance_share;  // of the atoms' own variance, per squared unit
};

Kernel makeKernel(const AtomMap& map, const GaussianProcessParameters& parameters) {
  const double radius = map.radius();
  const double square = radius * radius;
  if (map.mode() == Mode::kOccupancy) return {parameters.alpha / square, parameters.noise_variance, 1.0, 0.0};
  return {parameters.distance_alpha / square, parameters.distance_noise, radius,
          parameters.atom_variance_share / square};
}

// The atoms that a query is trained on, as seen from it.
struct Training {
  Offsets offsets;  // m
  Vector values;    // units
  Vector noise;     // squared units
};

Training makeTraining(const std::vector<Neighbor>& neighbors, const Eigen::Vector3f& query, const Kernel& kernel) {
  const auto n = static_cast<Eigen::Index>(neighbors.size());
  Training training{Offsets(3, n), Vector(n), Vector(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Neighbor& neighbor = neighbors[static_cast<std::size_t>(i)];
    training.offsets.col(i) = (neighbor.center - query).cast<double>();
    training.values[i] = neighbor.values[0] / kernel.unit;
    training.noise[i] = kernel.noise_variance + kernel.variance_share * neighbor.values[1];
  }
  return training;
}

// Eq. (7) between the training atoms.
Matrix covariance(const Offsets& offsets, const Vector& squared, double alpha) {
  const auto n = offsets.cols();
  Matrix exponents = 2.0 * offsets.transpose().lazyProduct(offsets);
  exponents -= squared.replicate(1, n) + squared.transpose().replicate(n, 1);
  return (alpha * exponents).array().exp();
}

}  // namespace

GaussianProcess::GaussianProcess(const AtomMap& map, const GaussianProcessParameters& parameters)
    : map_(map), parameters_(parameters) {}

std::optional<Estimate> GaussianProcess::estimate(const Eigen::Vector3f& point, float known_reach) {
  const float radius = map_.radius();
  map_.atoms().kNearest(point, parameters_.neighbors, 4.0F * radius, neighbors_);
  if (neighbors_.empty() || std::sqrt(neighbors_.front().squared_distance) >= known_reach * radius) return std::nullopt;

  const Kernel kernel = makeKernel(map_, parameters_);
  const Training training = makeTraining(neighbors_, point, kernel);
  const double mean = map_.mode() == Mode::kSignedDistance ? training.values.mean() : 0.0;
  const Vector squared = training.offsets.colwise().squaredNorm();
  const Vector to_query = (-kernel.alpha * squared).array().exp();  // Eq. (7)
  Matrix sigma = covariance(training.offsets, squared, kernel.alpha);
  sigma.diagonal() += training.noise;
  const Eigen::LLT<Matrix> factor(sigma);
  const Vector weights = factor.solve((training.values.array() - mean).matrix());
  const double value = mean + to_query.dot(weights);                                    // Eq. (8)
  const double variance = 1.0 - factor.matrixL().solve(to_query).eval().squaredNorm();  // Eq. (8)
  const Eigen::Vector3d gradient = 2.0 * kernel.alpha * training.offsets * weights.cwiseProduct(to_query);

  const double unit = kernel.unit;
  return Estimate{static_cast<float>(unit * value), static_cast<float>(unit * unit * std::max(variance, 0.0)),
                  (unit * gradient).cast<float>()};
}

}  // namespace atom_map
