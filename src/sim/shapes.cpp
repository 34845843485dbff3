#include "atom_mapping/sim/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace atom_map {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// An arbitrary unit vector stands in where the direction is undefined: on the axis or in the centre.
Vector3d direction(const Vector3d& v, const Vector3d& otherwise) {
  const double length = v.norm();
  return length > 0.0 ? Vector3d(v / length) : otherwise;
}

struct Interval {
  double enter;
  double leave;
};

// Roots of a t² + 2 b t + c = 0 in ascending order, in the form that does not cancel.
std::optional<Interval> solveQuadratic(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) return std::nullopt;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (q == 0.0) return Interval{0.0, 0.0};
  return Interval{std::min(q / a, c / q), std::max(q / a, c / q)};
}

// Where the line is inside the endless upright cylinder.
std::optional<Interval> crossMantle(const Vector2d& origin, const Vector2d& direction, double radius) {
  const double a = direction.squaredNorm();
  const double c = origin.squaredNorm() - radius * radius;
  if (a > 1e-24) return solveQuadratic(a, origin.dot(direction), c);
  if (c > 0.0) return std::nullopt;
  return Interval{-kInfinity, kInfinity};
}

// Where the line is between the caps at heights 0 and `height`.
std::optional<Interval> crossCaps(double z, double slope, double height) {
  if (slope != 0.0)
    return Interval{std::min(-z / slope, (height - z) / slope), std::max(-z / slope, (height - z) / slope)};
  if (z < 0.0 || z > height) return std::nullopt;
  return Interval{-kInfinity, kInfinity};
}

}  // namespace

SurfaceDistance Sphere::nearest(const Vector3d& point) const {
  const Vector3d offset = point - center;
  return {offset.norm() - radius, direction(offset, Vector3d::UnitZ())};
}

std::optional<Chord> Sphere::chord(const Vector3d& origin, const Vector3d& direction) const {
  const Vector3d offset = origin - center;
  const auto ends =
      solveQuadratic(direction.squaredNorm(), offset.dot(direction), offset.squaredNorm() - radius * radius);
  if (!ends || ends->leave < 0.0) return std::nullopt;
  return Chord{ends->enter, ends->leave, (offset + ends->enter * direction).normalized(),
               (offset + ends->leave * direction).normalized()};
}

SurfaceDistance Cylinder::nearest(const Vector3d& point) const {
  const Vector3d offset = point - base - Vector3d(0.0, 0.0, 0.5 * height);
  const Vector3d outward = direction(Vector3d(offset.x(), offset.y(), 0.0), Vector3d::UnitX());
  const Vector3d upward(0.0, 0.0, offset.z() < 0.0 ? -1.0 : 1.0);
  const double beyond_mantle = std::hypot(offset.x(), offset.y()) - radius;
  const double beyond_cap = std::abs(offset.z()) - 0.5 * height;
  if (beyond_mantle > 0.0 && beyond_cap > 0.0) {
    const double distance = std::hypot(beyond_mantle, beyond_cap);
    return {distance, (beyond_mantle * outward + beyond_cap * upward) / distance};
  }
  if (beyond_mantle > beyond_cap) return {beyond_mantle, outward};
  return {beyond_cap, upward};
}

std::optional<Chord> Cylinder::chord(const Vector3d& origin, const Vector3d& direction) const {
  const Vector3d offset = origin - base;
  const auto mantle = crossMantle(offset.head<2>(), direction.head<2>(), radius);
  const auto caps = crossCaps(offset.z(), direction.z(), height);
  if (!mantle || !caps) return std::nullopt;
  Chord chord{std::max(mantle->enter, caps->enter), std::min(mantle->leave, caps->leave), {}, {}};
  if (chord.enter > chord.leave || chord.leave < 0.0) return std::nullopt;
  const auto mantle_normal = [&](double t) {
    const Vector2d radial = (offset + t * direction).head<2>() / radius;
    return Vector3d(radial.x(), radial.y(), 0.0).normalized();
  };
  const Vector3d up(0.0, 0.0, direction.z() < 0.0 ? -1.0 : 1.0);
  chord.enter_normal = caps->enter > mantle->enter ? Vector3d(-up) : mantle_normal(chord.enter);
  chord.leave_normal = caps->leave < mantle->leave ? up : mantle_normal(chord.leave);
  return chord;
}

BoundingSphere Cylinder::bound() const {
  return {base + Vector3d(0.0, 0.0, 0.5 * height), std::hypot(radius, 0.5 * height)};
}

}  // namespace atom_map
