#include "atom_mapping/scan/half_width.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace atom_map {
namespace {

constexpr float kJump = 0.3F;  // m between the ranges of neighbours: not the same thing
constexpr int kMaxGap = 3;     // pixels without a return: a lost one, not yet the end of a thing
constexpr int kUnbounded = 1 << 20;

// Pixels from a return to the end of its thing on one side (direction 1 or -1); kUnbounded if none is found within
// max_pixels or something nearer hides it.
int pixelsToEdge(const RangeImage& image, const RangeImage::Pixel& start, float range, int direction, int max_pixels) {
  const RangeImage::Return* const ring = image.row(start.row);
  int last = 0;
  for (int i = 1; i <= max_pixels + kMaxGap; ++i) {
    if (i - last > kMaxGap) return last;
    const RangeImage::Return& beside = ring[image.wrapped(start.column + direction * i)];
    if (beside.index < 0) continue;
    if (beside.range > range + kJump) return last;
    if (beside.range < range - kJump) return kUnbounded;
    range = beside.range;
    last = i;
  }
  return kUnbounded;
}

}  // namespace

float halfWidth(const RangeImage& image, std::uint32_t ray, const Eigen::Vector3f& point, float max_width) {
  const RangeImage::Pixel pixel = image.pixel(ray);
  const float range = point.norm();
  const float pixel_width = range * image.columnAngle();
  const float half_turn = 0.5F * static_cast<float>(image.columns());
  const int max_pixels = static_cast<int>(std::min(max_width / pixel_width + 1.0F, half_turn));
  const int left = pixelsToEdge(image, pixel, range, 1, max_pixels);
  if (left == kUnbounded) return std::numeric_limits<float>::infinity();
  const int right = pixelsToEdge(image, pixel, range, -1, max_pixels);
  const float width = static_cast<float>(left + 1 + right) * pixel_width;
  return width <= max_width ? 0.5F * width : std::numeric_limits<float>::infinity();
}

float depthBehind(const SurfacePoint& point, float radius) {
  return std::isinf(point.half_width) ? radius : std::min(0.5F * radius, point.half_width);
}

}  // namespace atom_map
