#include "atom_mapping/ros/no_returns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "atom_mapping/base/quantile.h"

namespace atom_mapping {
namespace {

using Eigen::Vector3f;
using Angle = std::optional<float>;  // radians

constexpr float kPi = 3.14159265F;
constexpr float kMaxScatter = 0.5F * kPi / 180.0F;  // median deviation of the angles of a ring or a firing
constexpr float kMinRange = 1e-3F;                  // m, some drivers put what they do not know at the origin

bool isReturn(const Vector3f& p) {
  return p.allFinite() && p.squaredNorm() > kMinRange * kMinRange;
}

bool isNoReturn(const Vector3f& p) {
  return !p.hasNaN() && p.maxCoeff() == std::numeric_limits<float>::infinity();
}

float wrapped(float angle) {
  return std::remainder(angle, 2.0F * kPi);
}

// The angle that most of some angles agree on; nothing where they do not. `angles` is used up.
Angle commonAngle(std::vector<float>& angles) {
  if (angles.empty()) return std::nullopt;
  const float first = angles.front();
  for (float& angle : angles) angle = wrapped(angle - first);
  const float center = atom_map::quantile(angles, 0.5);
  for (float& angle : angles) angle = std::abs(angle - center);
  if (atom_map::quantile(angles, 0.5) > kMaxScatter) return std::nullopt;
  return wrapped(first + center);
}

// Of each ring.
std::vector<Angle> findElevations(const std::vector<Vector3f>& points, std::size_t rows, std::size_t columns) {
  std::vector<Angle> elevations;
  std::vector<float> angles;
  for (std::size_t row = 0; row < rows; ++row) {
    angles.clear();
    for (std::size_t i = row * columns; i < (row + 1) * columns; ++i) {
      if (isReturn(points[i])) angles.push_back(std::atan2(points[i].z(), points[i].head<2>().norm()));
    }
    elevations.push_back(commonAngle(angles));
  }
  return elevations;
}

// Of each firing that has returns.
std::vector<Angle> findAzimuths(const std::vector<Vector3f>& points, std::size_t rows, std::size_t columns) {
  std::vector<Angle> azimuths;
  std::vector<float> angles;
  for (std::size_t column = 0; column < columns; ++column) {
    angles.clear();
    for (std::size_t row = 0; row < rows; ++row) {
      const Vector3f& point = points[row * columns + column];
      if (isReturn(point)) angles.push_back(std::atan2(point.y(), point.x()));
    }
    azimuths.push_back(commonAngle(angles));
  }
  return azimuths;
}

// By how much the azimuth grows from one firing to the next; nothing where no two firings follow one another.
Angle findStep(const std::vector<Angle>& azimuths) {
  std::vector<float> steps;
  for (std::size_t i = 1; i < azimuths.size(); ++i) {
    if (azimuths[i - 1] && azimuths[i]) steps.push_back(wrapped(*azimuths[i] - *azimuths[i - 1]));
  }
  if (steps.empty()) return std::nullopt;
  return atom_map::quantile(steps, 0.5);
}

// Firings without a return, between such with one: only where less than half a turn and the sensor's step bear it out.
void fillGaps(std::vector<Angle>& azimuths) {
  const Angle step = findStep(azimuths);
  if (!step) return;
  std::size_t left = azimuths.size();
  for (std::size_t right = 0; right < azimuths.size(); ++right) {
    if (!azimuths[right]) continue;
    if (left < right) {
      const auto firings = static_cast<float>(right - left);
      const float turn = wrapped(*azimuths[right] - *azimuths[left]);
      const bool is_even = std::abs(*step * firings) < kPi && std::abs(turn - *step * firings) < 2.0F * kMaxScatter;
      for (std::size_t i = left + 1; is_even && i < right; ++i) {
        azimuths[i] = wrapped(*azimuths[left] + turn * static_cast<float>(i - left) / firings);
      }
    }
    left = right;
  }
}

Vector3f direction(float azimuth, float elevation) {
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

}  // namespace

std::vector<Vector3f> inferNoReturns(const std::vector<Vector3f>& points, std::size_t columns) {
  std::vector<Vector3f> directions;
  if (std::none_of(points.begin(), points.end(), isNoReturn)) return directions;
  const std::size_t rows = points.size() / columns;
  const std::vector<Angle> elevations = findElevations(points, rows, columns);
  std::vector<Angle> azimuths = findAzimuths(points, rows, columns);
  fillGaps(azimuths);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Angle& elevation = elevations[i / columns];
    const Angle& azimuth = azimuths[i % columns];
    if (isNoReturn(points[i]) && elevation && azimuth) directions.push_back(direction(*azimuth, *elevation));
  }
  return directions;
}

}  // namespace atom_mapping
