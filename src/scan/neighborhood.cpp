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
  const auto angle = static_cast<float>(parameters.normal_support / kDegree) / range;
  const auto steps = [&](double resolution, int samples) {
    return static_cast<int>(std::min(100.0F, 0.5F + angle / (static_cast<float>(resolution) * samples)));
  };
  const int widest = std::clamp(image.columns() / (4 * kSamplesBeside), 1, 30);  // samples span half a turn at most
  return {std::clamp(steps(parameters.vertical_resolution, kRingsBeside), 1, 3),
          std::clamp(steps(parameters.horizontal_resolution, kSamplesBeside), 1, widest)};
}

// The return in a pixel or in one beside it.
const RangeImage::Return& returnNear(const RangeImage& image, int row, int column) {
  for (const int beside : {0, 1}) {
    const RangeImage::Return& found = image.at(row, column + beside);
    if (found.index >= 0) return found;
  }
  return image.at(row, column - 1);
}

void gather(const RangeImage& image, std::uint32_t ray, const Eigen::Vector3f& point, const Steps& steps,
            Neighborhood& neighbors) {
  const RangeImage::Pixel middle = image.pixel(ray);
  for (int r = 0; r < Neighborhood::kRows; ++r) {
    const int row = middle.row + (r - kRingsBeside) * steps.row;
    for (int c = 0; c < Neighborhood::kColumns; ++c) {
      const RangeImage::Return& found = returnNear(image, row, middle.column + (c - kSamplesBeside) * steps.column);
      const bool is_neighbor = found.index >= 0 && found.index != static_cast<std::int32_t>(ray);
      neighbors.index[r][c] = is_neighbor ? neighbors.size : -1;
      if (!is_neighbor) continue;
      const Eigen::Vector3f offset = found.point - point;
      const int i = neighbors.size++;
      neighbors.x[i] = offset.x();
      neighbors.y[i] = offset.y();
      neighbors.z[i] = offset.z();
    }
  }
}

}  // namespace

Neighborhood collectNeighbors(const RangeImage& image, std::uint32_t ray, const Eigen::Vector3f& point,
                              const ScanParameters& parameters) {
  const float range = point.norm();
  const Steps steps = stepsAt(range, image, parameters);
  Neighborhood neighbors;
  gather(image, ray, point, steps, neighbors);
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
