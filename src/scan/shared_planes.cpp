#include "atom_mapping/scan/shared_planes.h"

#include <cmath>
#include <limits>

#include "atom_mapping/scan/estimate_normal.h"

namespace atom_map {
namespace {

constexpr float kWide = 8.0F;                // cells on the side of a wide one
constexpr std::size_t kReturnsPerCell = 4;   // about
constexpr std::size_t kReturnsPerWide = 32;  // about
constexpr float kAgreement = 0.999F;         // cosine of the angle between normals that agree: 2.6 degrees
constexpr int kSure = 3;                     // fits that agree on a plane that others of its wide cell may lie on

}  // namespace

float Patch::distanceTo(const Eigen::Vector3f& point) const {
  const float depth = -normal.dot(point);  // of the return, square to the plane
  const bool faces = depth > 0.0F && depth * depth > kMinFacing * kMinFacing * point.squaredNorm();
  return faces ? std::abs(distance - depth) : std::numeric_limits<float>::infinity();
}

const Patch* Patches::find(const Eigen::Vector3f& point, float tolerance) const {
  const Patch* found = nullptr;
  for (std::uint32_t i = 0; i < size_; ++i) {
    const float distance = planes_[i].distanceTo(point);
    if (distance >= tolerance) continue;
    tolerance = distance;
    found = &planes_[i];
  }
  return found;
}

void Patches::add(const Patch& patch) {
  if (size_ < planes_.size()) planes_[size_++] = patch;
}

void Patches::join(const Patch& patch, const Eigen::Vector3f& point, float tolerance) {
  for (std::uint32_t i = 0; i < size_; ++i) {
    Patch& plane = planes_[i];
    if (plane.normal.dot(patch.normal) < kAgreement || plane.distanceTo(point) > tolerance) continue;
    const float share = 1.0F / static_cast<float>(++plane.fits);
    plane.normal = (plane.normal + share * (patch.normal - plane.normal)).normalized();
    plane.distance += share * (patch.distance - plane.distance);
    return;
  }
  add(patch);
}

Patches& PatchCells::at(const Eigen::Vector3f& point) {
  std::uint32_t& number = cells_.at(point);
  if (number == 0) {
    patches_.emplace_back();
    number = static_cast<std::uint32_t>(patches_.size());
  }
  return patches_[number - 1];
}

SharedPlanes::SharedPlanes(float cell_size, float tolerance, std::size_t returns)
    : tolerance_(tolerance),
      cells_(cell_size, returns / kReturnsPerCell),
      wide_cells_(kWide * cell_size, returns / kReturnsPerWide) {}

std::optional<Eigen::Vector3f> SharedPlanes::normalAt(const Eigen::Vector3f& point) {
  Patches& patches = cells_.at(point);
  if (const Patch* const patch = patches.find(point, tolerance_)) return patch->normal;
  if (!patches.isEmpty()) return std::nullopt;
  const Patch* const patch = wide_cells_.at(point).find(point, tolerance_);
  if (patch == nullptr || patch->fits < kSure) return std::nullopt;
  patches.add(*patch);
  return patch->normal;
}

void SharedPlanes::add(const Patch& patch, const Eigen::Vector3f& point) {
  cells_.at(point).add(patch);
  wide_cells_.at(point).join(patch, point, tolerance_);
}

}  // namespace atom_map
