#include "atom_mapping/sim/scene.h"

#include <limits>
#include <utility>

namespace atom_map {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

BoundingSphere boundMatter(const Solid& solid) {
  if (solid.hollow) return {Vector3d::Zero(), kInfinity};
  return std::visit([](const auto& shape) { return shape.bound(); }, solid.shape);
}

// The floor of a room is ground, whatever its walls are.
SurfaceKind kindOfFace(const Solid& solid, const Vector3d& normal) {
  return solid.hollow && normal.z() > 0.9 ? SurfaceKind::kGround : solid.kind;
}

Nearest nearestOn(const Solid& solid, const Vector3d& point) {
  const SurfaceDistance found = std::visit([&](const auto& shape) { return shape.nearest(point); }, solid.shape);
  const double sign = solid.hollow ? -1.0 : 1.0;
  const Vector3d normal = sign * found.normal;
  return {sign * found.distance, normal, kindOfFace(solid, normal)};
}

std::optional<Hit> castOn(const Solid& solid, const Vector3d& origin, const Vector3d& direction) {
  const auto chord = std::visit([&](const auto& shape) { return shape.chord(origin, direction); }, solid.shape);
  if (!chord) return std::nullopt;
  const double range = solid.hollow ? chord->leave : chord->enter;
  if (range < 0.0 || range == kInfinity) return std::nullopt;
  const Vector3d normal = solid.hollow ? Vector3d(-chord->leave_normal) : chord->enter_normal;
  return Hit{range, origin + range * direction, normal, kindOfFace(solid, normal)};
}

// False only if the ball lies wholly off the first max_range metres of the ray.
bool mayMeet(const BoundingSphere& ball, const Vector3d& origin, const Vector3d& direction, double max_range) {
  const Vector3d offset = ball.center - origin;
  const double along = offset.dot(direction);
  return along >= -ball.radius && along - ball.radius <= max_range &&
         offset.squaredNorm() - along * along <= ball.radius * ball.radius;
}

}  // namespace

std::string toString(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::kGround:
      return "ground";
    case SurfaceKind::kWall:
      return "wall";
    case SurfaceKind::kColumn:
      return "column";
    case SurfaceKind::kPole:
      return "pole";
    case SurfaceKind::kTrunk:
      return "trunk";
    case SurfaceKind::kTree:
      return "tree";
    case SurfaceKind::kBox:
      return "box";
    case SurfaceKind::kCar:
      return "car";
    case SurfaceKind::kRamp:
      return "ramp";
  }
  return "unknown";
}

Scene::Scene(std::string name, std::vector<Solid> solids, const Eigen::AlignedBox3d& bounds)
    : name_(std::move(name)), solids_(std::move(solids)), bounds_(bounds) {
  bounding_spheres_.reserve(solids_.size());
  for (const Solid& solid : solids_) bounding_spheres_.push_back(boundMatter(solid));
}

Nearest Scene::nearest(const Vector3d& point) const {
  Nearest best{kInfinity, Vector3d::UnitZ(), SurfaceKind::kGround};
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    const BoundingSphere& ball = bounding_spheres_[i];
    const double reach = best.distance + ball.radius;  // a ball is no farther than its shape, inside as outside
    if (reach <= 0.0 || (ball.center - point).squaredNorm() >= reach * reach) continue;
    const Nearest found = nearestOn(solids_[i], point);
    if (found.distance < best.distance) best = found;
  }
  return best;
}

std::optional<Hit> Scene::castRay(const Vector3d& origin, const Vector3d& direction, double max_range) const {
  std::optional<Hit> first;
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    if (!mayMeet(bounding_spheres_[i], origin, direction, first ? first->range : max_range)) continue;
    const auto hit = castOn(solids_[i], origin, direction);
    if (hit && hit->range <= max_range && (!first || hit->range < first->range)) first = hit;
  }
  return first;
}

}  // namespace atom_map
