#include "atom_mapping/sim/convex_polyhedron.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace atom_map {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTolerance = 1e-10;  // m, by which a point may lie before a face and still count as inside

}  // namespace

ConvexPolyhedron::ConvexPolyhedron(std::vector<Plane> faces) : faces_(std::move(faces)) {
  findEdges();
}

void ConvexPolyhedron::findEdges() {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    for (std::size_t j = i + 1; j < faces_.size(); ++j) {
      const Vector3d along = faces_[i].normal().cross(faces_[j].normal());
      if (along.norm() < 1e-9) continue;
      Eigen::Matrix3d normals;
      normals << faces_[i].normal().transpose(), faces_[j].normal().transpose(), along.transpose();
      const Vector3d on_both = normals.inverse() * Vector3d(-faces_[i].offset(), -faces_[j].offset(), 0.0);
      if (auto edge = clipToFaces({on_both, along.normalized(), -kInfinity, kInfinity}, i, j)) edges_.push_back(*edge);
    }
  }
}

std::optional<ConvexPolyhedron::Edge> ConvexPolyhedron::clipToFaces(Edge line, std::size_t i, std::size_t j) const {
  for (std::size_t k = 0; k < faces_.size(); ++k) {
    if (k == i || k == j) continue;
    const double before = faces_[k].signedDistance(line.point);
    const double slope = faces_[k].normal().dot(line.direction);
    if (std::abs(slope) < 1e-12) {
      if (before > kTolerance) return std::nullopt;
    } else if (slope > 0.0) {
      line.end = std::min(line.end, -before / slope);
    } else {
      line.start = std::max(line.start, -before / slope);
    }
  }
  if (line.start > line.end) return std::nullopt;
  return line;
}

bool ConvexPolyhedron::contains(const Vector3d& point) const {
  return std::all_of(faces_.begin(), faces_.end(),
                     [&](const Plane& f) { return f.signedDistance(point) <= kTolerance; });
}

SurfaceDistance ConvexPolyhedron::nearest(const Vector3d& point) const {
  SurfaceDistance nearest{-kInfinity, Vector3d::UnitZ()};
  for (const Plane& face : faces_) {
    const double distance = face.signedDistance(point);
    if (distance > nearest.distance) nearest = {distance, face.normal()};
  }
  // The farthest plane is where the nearest point lies, if the foot of its perpendicular belongs to the polyhedron.
  if (nearest.distance <= 0.0 || contains(point - nearest.distance * nearest.normal)) return nearest;
  return nearestOutside(point);
}

SurfaceDistance ConvexPolyhedron::nearestOutside(const Vector3d& point) const {
  for (const Plane& face : faces_) {
    const double distance = face.signedDistance(point);
    if (distance > 0.0 && contains(point - distance * face.normal())) return {distance, face.normal()};
  }
  double least = kInfinity;
  Vector3d foot = point;
  for (const Edge& edge : edges_) {
    const double along = std::clamp(edge.direction.dot(point - edge.point), edge.start, edge.end);
    const Vector3d candidate = edge.point + along * edge.direction;
    const double squared = (point - candidate).squaredNorm();
    if (squared < least) {
      least = squared;
      foot = candidate;
    }
  }
  return {std::sqrt(least), (point - foot).normalized()};
}

std::optional<Chord> ConvexPolyhedron::chord(const Vector3d& origin, const Vector3d& direction) const {
  Chord chord{-kInfinity, kInfinity, -direction, direction};
  for (const Plane& face : faces_) {
    const double before = face.signedDistance(origin);
    const double slope = face.normal().dot(direction);
    if (slope == 0.0) {
      if (before > 0.0) return std::nullopt;
    } else if (slope < 0.0 && -before / slope > chord.enter) {
      chord.enter = -before / slope;
      chord.enter_normal = face.normal();
    } else if (slope > 0.0 && -before / slope < chord.leave) {
      chord.leave = -before / slope;
      chord.leave_normal = face.normal();
    }
    if (chord.enter > chord.leave || chord.leave < 0.0) return std::nullopt;
  }
  return chord;
}

BoundingSphere ConvexPolyhedron::bound() const {
  Eigen::AlignedBox3d box;
  for (const Edge& edge : edges_) {
    if (!std::isfinite(edge.start) || !std::isfinite(edge.end)) return {Vector3d::Zero(), kInfinity};
    box.extend(edge.point + edge.start * edge.direction).extend(edge.point + edge.end * edge.direction);
  }
  if (box.isEmpty()) return {Vector3d::Zero(), kInfinity};
  return {box.center(), 0.5 * box.diagonal().norm()};
}

ConvexPolyhedron makePrism(const Eigen::Isometry3d& pose, const std::vector<Eigen::Vector2d>& profile, double width) {
  std::vector<Plane> faces;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const Eigen::Vector2d side = profile[(i + 1) % profile.size()] - profile[i];
    const Vector3d outward = Vector3d(side.y(), 0.0, -side.x()).normalized();
    faces.emplace_back(Vector3d(pose.linear() * outward), pose * Vector3d(profile[i].x(), 0.0, profile[i].y()));
  }
  for (const double side : {-1.0, 1.0}) {
    const Vector3d outward(0.0, side, 0.0);
    faces.emplace_back(Vector3d(pose.linear() * outward), pose * Vector3d(0.5 * width * outward));
  }
  return ConvexPolyhedron(std::move(faces));
}

ConvexPolyhedron makeBox(const Eigen::Isometry3d& pose, const Vector3d& size) {
  const double x = 0.5 * size.x();
  const double z = 0.5 * size.z();
  return makePrism(pose, {{-x, -z}, {x, -z}, {x, z}, {-x, z}}, size.y());
}

}  // namespace atom_map
