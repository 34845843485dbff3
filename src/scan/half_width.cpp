#include "atom_mapping/scan/half_width.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace atom_map {
namespace {

constexpr float kJump = 0.3F;  // m between the ranges of neighbours: not the same thing
constexpr int kMaxGap = 3;     // pixels without a return: a lost one, not yet the end of a thing
constexpr int kUnbounded = 1 << 20;

// Pixels from the ray to the end of its thing on one side (direction 1 or -1); kUnbounded if none is found within
// max_pixels or something nearer hides it.
int pixelsToEdge(const FilteredScan& scan, const RangeImage& image, std::uint32_t ray, int direction, int max_pixels) {
  const RangeImage::Pixel start = image.pixel(ray);
  float range = scan.points[ray].norm();
  int last = 0;
  for (int i = 1; i <= max_pixels + kMaxGap; ++i) {
    if (i - last > kMaxGap) return last;
    const std::int32_t beside = image.at(start.row, start.column + direction * i);
    if (beside < 0) continue;
    const float range_beside = scan.points[static_cast<std::size_t>(beside)].norm();
    if (range_beside > range + kJump) return last;
    if (range_beside < range - kJump) return kUnbounded;
    range = range_beside;
    last = i;
  }
  return kUnbounded;
}

}  // namespace

float halfWidth(const FilteredScan& scan, const RangeImage& image, std::uint32_t ray, float max_width) {
  const float pixel_width = scan.points[ray].norm() * image.columnAngle();
  const float half_turn = 0.5F * static_cast<float>(image.columns());
  const int max_pixels = static_cast<int>(std::min(max_width / pixel_width + 1.0F, half_turn));
  const int left = pixelsToEdge(scan, image, ray, 1, max_pixels);
  if (left == kUnbounded) return std::numeric_limits<float>::infinity();
  const int right = pixelsToEdge(scan, image, ray, -1, max_pixels);
  const float width = static_cast<float>(left + 1 + right) * pixel_width;
  return width <= max_width ? 0.5F * width : std::numeric_limits<float>::infinity();
}

float depthBehind(const SurfacePoint& point, float radius) {
  return std::isinf(point.half_width) ? radius : std::min(0.5F * radius, point.half_width);
}

}  // namespace atom_map
