#include "atom_mapping/scan/neighborhood.h"

#include <algorithm>
#include <array>
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
  const auto angle = static_cast<float>(parameters.normal_support / kDegree) / range;
  const auto steps = [&](double resolution, int samples) {
    return static_cast<int>(std::min(100.0F, 0.5F + angle / (static_cast<float>(resolution) * samples)));
  };
  const int widest = std::clamp(image.columns() / (4 * kSamplesBeside), 1, 30);  // samples span half a turn at most
  return {std::clamp(steps(parameters.vertical_resolution, kRingsBeside), 1, 3),
          std::clamp(steps(parameters.horizontal_resolution, kSamplesBeside), 1, widest)};
}

// The return in a pixel of a ring or in one beside it; -1 where all three are empty.
std::int32_t returnNear(const RangeImage& image, const RangeImage::Return* ring, int column) {
  if (ring[column].index >= 0) return ring[column].index;
  const std::int32_t beside = ring[image.wrapped(column + 1)].index;
  return beside >= 0 ? beside : ring[image.wrapped(column - 1)].index;
}

void gather(const RangeImage& image, const std::vector<Eigen::Vector3f>& points, std::uint32_t ray, const Steps& steps,
            Neighborhood& neighbors) {
  const RangeImage::Pixel middle = image.pixel(ray);
  const Eigen::Vector3f& point = points[ray];
  std::array<int, Neighborhood::kColumns> columns{};
  for (int c = 0; c < Neighborhood::kColumns; ++c) {
    columns[c] = image.wrapped(middle.column + (c - kSamplesBeside) * steps.column);
  }
  int size = 0;
  for (int r = 0; r < Neighborhood::kRows; ++r) {
    neighbors.index[r].fill(-1);
    const RangeImage::Return* const ring = image.row(middle.row + (r - kRingsBeside) * steps.row);
    if (ring == nullptr) continue;
    std::int32_t last = -1;  // empty columns share a return with the one beside them
    for (int c = 0; c < Neighborhood::kColumns; ++c) {
      const std::int32_t found = returnNear(image, ring, columns[c]);
      if (found < 0 || found == last || found == static_cast<std::int32_t>(ray)) continue;
      last = found;
      const Eigen::Vector3f& neighbor = points[static_cast<std::size_t>(found)];
      neighbors.x[size] = neighbor.x() - point.x();
      neighbors.y[size] = neighbor.y() - point.y();
      neighbors.z[size] = neighbor.z() - point.z();
      neighbors.index[r][c] = size++;
    }
  }
  neighbors.size = size;
}

}  // namespace

Neighborhood collectNeighbors(const RangeImage& image, const std::vector<Eigen::Vector3f>& points, std::uint32_t ray,
                              const ScanParameters& parameters) {
  const float range = points[ray].norm();
  const Steps steps = stepsAt(range, image, parameters);
  Neighborhood neighbors;
  gather(image, points, ray, steps, neighbors);
  const auto ring_spacing = static_cast<float>(range * parameters.vertical_resolution * kDegree * steps.row);
  const float reach = std::max(ring_spacing, static_cast<float>(parameters.normal_support));
  const auto noise = static_cast<float>(parameters.range_noise);
  const Neighborhood::Floats squared = neighbors.x.square() + neighbors.y.square() + neighbors.z.square();
  neighbors.per_tolerance = (3.0F * noise + 1e-3F + kCurvature * squared.sqrt()).inverse();
  neighbors.weight = (1.0F + squared / (reach * reach)).inverse();
  neighbors.weight.tail(Neighborhood::kPlaces - neighbors.size).setZero();
  return neighbors;
}

}  // namespace atom_map
