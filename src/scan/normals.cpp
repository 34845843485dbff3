#include "atom_mapping/scan/normals.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "atom_mapping/base/angles.h"
#include "atom_mapping/scan/half_width.h"
#include "atom_mapping/scan/neighborhood.h"
#include "atom_mapping/scan/range_image.h"

namespace atom_map {
namespace {

constexpr float kMinFacing = 0.05F;  // cosine between normal and ray: a plane seen more obliquely is the edge of a step

// Weighted sum of the squared distances from a plane through the point, in units of their tolerance and at most one.
float disagreement(const Neighborhood& neighbors, const Eigen::Vector3f& normal) {
  const auto distance = neighbors.x * normal.x() + neighbors.y * normal.y() + neighbors.z * normal.z();
  return (neighbors.weight * (distance * neighbors.per_tolerance).square().min(1.0F)).sum();
}

// The normal that most neighbours agree on, of planes through the point, a neighbour on its ring and one on another,
// and of planes through the point and one on another ring that face the sensor as far as they can (poles).
Eigen::Vector3f agreedNormal(const Neighborhood& neighbors, const Eigen::Vector3f& towards_sensor) {
  Eigen::Vector3f best = towards_sensor;
  float least = std::numeric_limits<float>::infinity();
  const auto propose = [&](const Eigen::Vector3f& direction) {
    const Eigen::Vector3f normal = direction.normalized();
    if (!(std::abs(normal.dot(towards_sensor)) > kMinFacing)) return;
    const float sum = disagreement(neighbors, normal);
    if (sum >= least) return;
    least = sum;
    best = normal;
  };
  for (const int row : {0, 1, 3, 4}) {
    for (const int column : {0, 4, 8}) {
      const int across = neighbors.index[row][column];
      if (across < 0) continue;
      const Eigen::Vector3f line = neighbors.offset(across);
      if (column == 4) propose(towards_sensor - line * (line.dot(towards_sensor) / line.squaredNorm()));
      for (const int beside : {2, 6}) {
        const int along = neighbors.index[Neighborhood::kRingsBeside][beside];
        if (along >= 0) propose(neighbors.offset(along).cross(line));
      }
    }
  }
  return best;
}

enum class Fit { kPlane, kLine, kNone };

struct Normal {
  Eigen::Vector3f direction;
  Fit fit;
};

struct Plane {
  Eigen::Vector3f spread;  // variances, ascending
  Eigen::Matrix3f axes;    // columns, in their order
};

// Of the point and the neighbours that agree with the normal; nothing if these are fewer than two.
std::optional<Plane> leastSquares(const Neighborhood& neighbors, const Eigen::Vector3f& normal) {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  Eigen::Matrix3f sum = Eigen::Matrix3f::Zero();
  float weights = 1.0F;  // the point itself
  int count = 0;
  for (int i = 0; i < neighbors.size; ++i) {
    if (!neighbors.agrees(i, normal)) continue;
    const Eigen::Vector3f weighted = neighbors.weight[i] * neighbors.offset(i);
    mean += weighted;
    sum += weighted * neighbors.offset(i).transpose();
    weights += neighbors.weight[i];
    ++count;
  }
  if (count < 2) return std::nullopt;
  mean /= weights;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(sum / weights - mean * mean.transpose());
  return Plane{solver.eigenvalues().cwiseMax(0.0F), solver.eigenvectors()};
}

// Least squares over the neighbours that agree; falls back where they do not span a plane.
Normal refine(const Neighborhood& neighbors, const Eigen::Vector3f& agreed, const Eigen::Vector3f& towards_sensor,
              float noise) {
  const std::optional<Plane> plane = leastSquares(neighbors, agreed);
  if (!plane) return {towards_sensor, Fit::kNone};
  if (std::sqrt(plane->spread[1]) < 2.0F * noise) {
    const Eigen::Vector3f line = plane->axes.col(2);
    const Eigen::Vector3f square = towards_sensor - line * line.dot(towards_sensor);
    if (square.norm() < kMinFacing) return {towards_sensor, Fit::kNone};
    return {square.normalized(), Fit::kLine};
  }
  const Eigen::Vector3f normal = plane->axes.col(0);
  return {normal.dot(towards_sensor) < 0.0F ? Eigen::Vector3f(-normal) : normal, Fit::kPlane};
}

}  // namespace

std::vector<SurfacePoint> estimateSurface(const FilteredScan& scan, const ScanParameters& parameters,
                                          NormalReport& report) {
  const RangeImage image(scan.points, parameters.horizontal_resolution * kDegree,
                         parameters.vertical_resolution * kDegree);
  std::vector<SurfacePoint> surface;
  surface.reserve(scan.rays.size());
  for (const std::uint32_t ray : scan.rays) {
    const Eigen::Vector3f towards_sensor = -scan.points[ray].normalized();
    const Neighborhood neighbors = collectNeighbors(scan, image, ray, parameters);
    const Eigen::Vector3f agreed = agreedNormal(neighbors, towards_sensor);
    const Normal normal = refine(neighbors, agreed, towards_sensor, static_cast<float>(parameters.range_noise));
    report.from_line += normal.fit == Fit::kLine ? 1 : 0;
    report.from_ray += normal.fit == Fit::kNone ? 1 : 0;
    surface.push_back(
        {scan.points[ray], normal.direction, halfWidth(scan, image, ray, static_cast<float>(parameters.thin_width))});
  }
  return surface;
}

}  // namespace atom_map
