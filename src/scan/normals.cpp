#include "atom_mapping/scan/normals.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "atom_mapping/scan/half_width.h"
#include "atom_mapping/scan/range_image.h"

namespace atom_map {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr int kRingsBeside = 2;      // looked at above and below
constexpr int kSamplesBeside = 4;    // looked at left and right on each ring
constexpr float kMinFacing = 0.05F;  // cosine between normal and ray: a plane seen more obliquely is the edge of a step
constexpr float kCurvature = 0.03F;  // distance from the plane that is tolerated, over the distance from the point

// The neighbours of one return, relative to it. Nearer ones weigh more.
struct Neighborhood {
  static constexpr int kRows = 2 * kRingsBeside + 1;
  static constexpr int kColumns = 2 * kSamplesBeside + 1;
  static constexpr int kPlaces = (kRows * kColumns + 3) / 4 * 4;  // whole vector registers
  using Floats = Eigen::Array<float, kPlaces, 1>;
  Floats weight = Floats::Zero();  // 0 where there is no neighbour
  Floats x, y, z;                  // m
  Floats per_tolerance;            // 1 / m
  int size = 0;
  std::array<std::array<int, kColumns>, kRows> index;  // of a row and column, or -1

  Neighborhood() : x(weight), y(weight), z(weight), per_tolerance(weight) {
    for (auto& row : index) row.fill(-1);
  }

  Eigen::Vector3f offset(int i) const { return {x[i], y[i], z[i]}; }
  bool agrees(int i, const Eigen::Vector3f& normal) const {
    return std::abs(offset(i).dot(normal)) * per_tolerance[i] <= 1.0F;
  }
};

// Steps through the range image so that the samples reach out to the support, but over one pixel at least.
struct Steps {
  int row;
  int column;
};

Steps stepsAt(float range, const ScanParameters& parameters) {
  const double angle = parameters.normal_support / range;
  const auto steps = [&](double resolution, int samples) {
    return static_cast<int>(std::lround(angle / (resolution * kDegree * samples)));
  };
  return {std::clamp(steps(parameters.vertical_resolution, kRingsBeside), 1, 3),
          std::clamp(steps(parameters.horizontal_resolution, kSamplesBeside), 1, 30)};
}

// The return in a pixel or in one beside it; -1 without one.
std::int32_t returnNear(const RangeImage& image, int row, int column) {
  for (const int beside : {0, 1, -1}) {
    if (const std::int32_t found = image.at(row, column + beside); found >= 0) return found;
  }
  return -1;
}

Neighborhood collect(const FilteredScan& scan, const RangeImage& image, std::uint32_t ray,
                     const ScanParameters& parameters) {
  Neighborhood neighbors;
  const Eigen::Vector3f& point = scan.points[ray];
  const float range = point.norm();
  const Steps steps = stepsAt(range, parameters);
  const auto ring_spacing = static_cast<float>(range * parameters.vertical_resolution * kDegree * steps.row);
  const float reach = std::max(ring_spacing, static_cast<float>(parameters.normal_support));
  const auto noise = static_cast<float>(parameters.range_noise);
  for (int r = 0; r < Neighborhood::kRows; ++r) {
    for (int c = 0; c < Neighborhood::kColumns; ++c) {
      const std::int32_t found = returnNear(image, image.pixel(ray).row + (r - kRingsBeside) * steps.row,
                                            image.pixel(ray).column + (c - kSamplesBeside) * steps.column);
      if (found < 0 || found == static_cast<std::int32_t>(ray)) continue;
      const Eigen::Vector3f offset = scan.points[static_cast<std::size_t>(found)] - point;
      const float distance = offset.norm();
      const int i = neighbors.size++;
      neighbors.index[r][c] = i;
      neighbors.x[i] = offset.x();
      neighbors.y[i] = offset.y();
      neighbors.z[i] = offset.z();
      neighbors.per_tolerance[i] = 1.0F / (3.0F * noise + kCurvature * distance + 1e-3F);
      neighbors.weight[i] = 1.0F / (1.0F + distance * distance / (reach * reach));
    }
  }
  return neighbors;
}

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
        const int along = neighbors.index[kRingsBeside][beside];
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
    const Neighborhood neighbors = collect(scan, image, ray, parameters);
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
