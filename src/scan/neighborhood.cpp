#include "atom_mapping/scan/neighborhood.h"

#include <algorithm>
#include <cmath>

#include "atom_mapping/base/angles.h"

namespace atom_map {
namespace {

constexpr int kRingsBeside = Neighborhood::kRingsBeside;
constexpr int kSamplesBeside = Neighborhood::kSamplesBeside;
constexpr float kCurvature = 0.03F;  // distance from a plane that is tolerated, over the distance from the point

// Steps through the range image so that the samples reach out to the support, but over one pixel at least.
struct Steps {
  int row;
  int column;
};

Steps stepsAt(float range, const RangeImage& image, const ScanParameters& parameters) {
  const double angle = parameters.normal_support / range;
  const auto steps = [&](double resolution, int samples) {
    return static_cast<int>(std::lround(angle / (resolution * kDegree * samples)));
  };
  const int widest = std::clamp(image.columns() / (4 * kSamplesBeside), 1, 30);  // samples span half a turn at most
  return {std::clamp(steps(parameters.vertical_resolution, kRingsBeside), 1, 3),
          std::clamp(steps(parameters.horizontal_resolution, kSamplesBeside), 1, widest)};
}

// The return in a pixel or in one beside it; -1 without one.
std::int32_t returnNear(const RangeImage& image, int row, int column) {
  for (const int beside : {0, 1, -1}) {
    if (const std::int32_t found = image.at(row, column + beside); found >= 0) return found;
  }
  return -1;
}

}  // namespace

Neighborhood collectNeighbors(const FilteredScan& scan, const RangeImage& image, std::uint32_t ray,
                              const ScanParameters& parameters) {
  Neighborhood neighbors;
  const Eigen::Vector3f& point = scan.points[ray];
  const float range = point.norm();
  const Steps steps = stepsAt(range, image, parameters);
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

}  // namespace atom_map
