#include "atom_mapping/scan/estimate_normal.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <optional>

#include "atom_mapping/scan/fit_plane.h"

namespace atom_map {
namespace {

// Weighted sum of the squared distances from a plane, in units of their tolerance and at most one. The normal may have any
// length; the plane passes `offset` lengths of it from the point.
float disagreement(const Neighborhood& neighbors, const Eigen::Vector3f& normal, float offset = 0.0F) {
  const float per_length = 1.0F / normal.squaredNorm();
  const auto squared = ((neighbors.along(normal) - offset) * neighbors.per_tolerance).square() * per_length;
  return (neighbors.weight * squared.min(1.0F)).sum();
}

// Weights that fall to zero where neighbours leave their tolerance. `normal`: unit.
Neighborhood::Floats weightsOn(const Neighborhood& neighbors, const Eigen::Vector3f& normal, float offset = 0.0F) {
  const auto squared = ((neighbors.along(normal) - offset) * neighbors.per_tolerance).square();
  return neighbors.weight * (1.0F - squared.square()).max(0.0F);
}

// The normal that most neighbours agree on, of planes through the point, a neighbour on its ring and one on another,
// and of planes through the point and one on another ring that face the sensor as far as they can (poles).
Eigen::Vector3f agreedNormal(const Neighborhood& neighbors, const Eigen::Vector3f& towards_sensor) {
  Eigen::Vector3f best = towards_sensor;
  float least = std::numeric_limits<float>::infinity();
  const float enough = 0.3F * neighbors.weight.sum();  // disagreement of so few is no reason to look further
  constexpr float kTiny = 1e-30F;                      // below it floats lose their digits
  const auto propose = [&](const Eigen::Vector3f& normal) {
    if (least < enough) return;
    const float facing = normal.dot(towards_sensor);
    const float squared_length = normal.squaredNorm();
    if (squared_length < kTiny || facing * facing <= kMinFacing * kMinFacing * squared_length) return;
    const float sum = disagreement(neighbors, normal);
    if (sum >= least) return;
    least = sum;
    best = normal;
  };
  for (const int row : {1, 3, 0, 4}) {
    const bool inner = row == 1 || row == 3;
    if (!inner && least < std::numeric_limits<float>::infinity())
      break;  // the outer rings where the inner ones are empty
    for (const int column : {0, 4, 8}) {
      const int across = neighbors.index[row][column];
      if (across < 0) continue;
      const Eigen::Vector3f line = neighbors.offset(across);
      if (column == 4) propose(towards_sensor * line.squaredNorm() - line * line.dot(towards_sensor));
      for (const int beside : {2, 6}) {
        const int along = neighbors.index[Neighborhood::kRingsBeside][beside];
        if (along >= 0) propose(neighbors.offset(along).cross(line));
      }
    }
  }
  return best.normalized();
}

Eigen::Vector3f turnedTowards(const Eigen::Vector3f& sensor, const Eigen::Vector3f& normal) {
  return normal.dot(sensor) < 0.0F ? Eigen::Vector3f(-normal) : normal;
}

// The plane that the point and nearly all its neighbours lie on; nothing where there is none.
std::optional<Normal> commonPlane(const Neighborhood& neighbors, const Eigen::Vector3f& towards_sensor, float noise) {
  constexpr float kFew = 0.15F;  // of the neighbours' weight: what noise alone gives, and some
  const Moments all = momentsOf(neighbors, neighbors.weight);
  const PlaneFit first = fitPlane(all.covariance);
  const float first_offset = first.normal.dot(all.mean);
  if (first.breadth <= 2.0F * noise) return std::nullopt;
  if (disagreement(neighbors, first.normal, first_offset) > kFew * neighbors.weight.sum()) return std::nullopt;
  const Moments agreeing = momentsOf(neighbors, weightsOn(neighbors, first.normal, first_offset));
  const Eigen::Vector3f normal = turnedTowards(towards_sensor, fitPlane(agreeing.covariance).normal);
  const float offset = normal.dot(agreeing.mean);
  if (normal.dot(towards_sensor) <= kMinFacing || std::abs(offset) > 3.0F * noise + 1e-3F) return std::nullopt;
  return Normal{normal, Fit::kPlane, offset};
}

// Least squares over the neighbours that agree; falls back where they do not span a plane.
Normal refine(const Neighborhood& neighbors, const Eigen::Vector3f& agreed, const Eigen::Vector3f& towards_sensor,
              float noise) {
  const Neighborhood::Floats weight = weightsOn(neighbors, agreed);
  if ((weight > 0.0F).count() < 2) return {towards_sensor, Fit::kNone};
  const Moments moments = momentsOf(neighbors, weight);
  const PlaneFit plane = fitPlane(moments.covariance);
  if (plane.breadth > 2.0F * noise) {
    const Eigen::Vector3f normal = turnedTowards(towards_sensor, plane.normal);
    return {normal, Fit::kPlane, normal.dot(moments.mean)};
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(moments.covariance);
  const Eigen::Vector3f line = solver.eigenvectors().col(2);
  const Eigen::Vector3f square = towards_sensor - line * line.dot(towards_sensor);
  if (square.norm() < kMinFacing) return {towards_sensor, Fit::kNone};
  return {square.normalized(), Fit::kLine};
}

}  // namespace

Normal estimateNormal(const Neighborhood& neighbors, const Eigen::Vector3f& towards_sensor, float noise) {
  if (const auto plane = commonPlane(neighbors, towards_sensor, noise)) return *plane;
  return refine(neighbors, agreedNormal(neighbors, towards_sensor), towards_sensor, noise);
}

}  // namespace atom_map
