#include "atom_mapping/query/gaussian_process.h"

#include <Eigen/Cholesky>

namespace atom_map {
namespace {

constexpr int kMaxNeighbors = 64;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxNeighbors, 1>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxNeighbors, kMaxNeighbors>;

// Kernel matrix among the neighbours plus the noise, lower triangle. `alpha` per square metre.
Matrix covariance(const std::vector<Neighbor>& neighbors, double alpha, double noise_variance) {
  const auto n = static_cast<Eigen::Index>(neighbors.size());
  Matrix sigma(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const Eigen::Vector3f apart =
          neighbors[static_cast<std::size_t>(i)].center - neighbors[static_cast<std::size_t>(j)].center;
      sigma(i, j) = std::exp(-alpha * apart.squaredNorm());  // Eq. (7)
    }
    sigma(i, i) = 1.0 + noise_variance;
  }
  return sigma;
}

}  // namespace

GaussianProcess::GaussianProcess(const AtomMap& map, const GaussianProcessParameters& parameters)
    : map_(map), parameters_(parameters) {}

std::optional<Estimate> GaussianProcess::estimate(const Eigen::Vector3f& point) {
  const float radius = map_.radius();
  map_.atoms().kNearest(point, parameters_.neighbors, 4.0F * radius, neighbors_);
  if (neighbors_.empty() || neighbors_.front().squared_distance >= 4.0F * radius * radius) return std::nullopt;

  const bool distances = map_.mode() == Mode::kSignedDistance;
  const double alpha = (distances ? parameters_.distance_alpha : parameters_.alpha) / (radius * radius);
  const double noise = distances ? parameters_.distance_noise : parameters_.noise_variance;
  const double unit = distances ? radius : 1.0;  // of the values, so that the kernel's variance of 1 fits them
  const auto n = static_cast<Eigen::Index>(neighbors_.size());
  Vector values(n);
  Vector to_query(n);  // one column of the covariance between query and training points
  for (Eigen::Index i = 0; i < n; ++i) {
    const Neighbor& neighbor = neighbors_[static_cast<std::size_t>(i)];
    values[i] = neighbor.values[0] / unit;
    to_query[i] = std::exp(-alpha * neighbor.squared_distance);
  }
  const double mean = distances ? values.mean() : 0.0;
  const Eigen::LLT<Matrix> sigma(covariance(neighbors_, alpha, noise));
  const Vector weights = sigma.solve((values.array() - mean).matrix());
  const double value = mean + to_query.dot(weights);                  // Eq. (8)
  const double variance = 1.0 - to_query.dot(sigma.solve(to_query));  // Eq. (8)

  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Vector3f from = point - neighbors_[static_cast<std::size_t>(i)].center;
    gradient -= 2.0 * alpha * weights[i] * to_query[i] * from.cast<double>();
  }
  return Estimate{static_cast<float>(unit * value), static_cast<float>(unit * unit * std::max(variance, 0.0)),
                  (unit * gradient).cast<float>()};
}

}  // namespace atom_map
