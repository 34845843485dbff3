#include "atom_mapping/scan/shared_planes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "atom_mapping/scan/estimate_normal.h"

namespace atom_map {
namespace {

constexpr float kWide = 8.0F;                // cells on the side of a wide one,
constexpr float kLeastWide = 3.0F;           // and metres at least
constexpr std::size_t kReturnsPerCell = 16;  // about
constexpr std::size_t kReturnsPerWide = 32;  // about
constexpr float kAgreement = 0.999F;         // cosine of the angle between normals that agree: 2.6 degrees
constexpr float kTurned = 0.98F;             // of those whose surface is another one: 11 degrees
constexpr int kSure = 3;                     // fits that agree on a plane that others of its wide cell may lie on
constexpr int kMostFits = 16;                // that a plane is the mean of; then the latest count for more
constexpr std::uint32_t kFitAgain = 64;      // of so many returns on known planes one is fitted all the same

}  // namespace

float Patch::distanceTo(const Eigen::Vector3f& point) const {
  return std::abs(normal.dot(point) - level);
}

// A return can lie on a plane unless the sensor would see that from behind or too obliquely.
std::optional<std::uint32_t> Patches::find(const Eigen::Vector3f& point, const Eigen::Vector3f& sensor, float tolerance,
                                           int least_fits) const {
  const Eigen::Vector3f ray = sensor - point;
  const float least_depth = kMinFacing * kMinFacing * ray.squaredNorm();  // squared
  std::optional<std::uint32_t> found;
  for (std::uint32_t first = 0; first < size_; first += kLane) {
    const Lane& lane = lanes_[first / kLane];
    const Floats depth = lane.x * ray.x() + lane.y * ray.y() + lane.z * ray.z();
    const Floats offset = lane.x * point.x() + lane.y * point.y() + lane.z * point.z() - lane.level;
    const Bits may_lie = (lane.fits >= least_fits) & (depth > 0.0F) & (depth * depth > least_depth);
    Floats distance = offset < 0.0F ? -offset : offset;
    distance = may_lie ? distance : Floats{} + std::numeric_limits<float>::infinity();
    const std::uint32_t i = indexOfLeast(distance);
    if (distance[i] >= tolerance) continue;
    tolerance = distance[i];
    found = first + i;
  }
  return found;
}

Patch Patches::operator[](std::uint32_t i) const {
  assert(i < size_);
  const Lane& lane = lanes_[i / kLane];
  const std::uint32_t at = i % kLane;
  return {{lane.x[at], lane.y[at], lane.z[at]}, lane.level[at], lane.fits[at], lane.is_seen[at] != 0};
}

void Patches::set(std::uint32_t i, const Patch& patch) {
  assert(i < size_);
  Lane& lane = lanes_[i / kLane];
  const std::uint32_t at = i % kLane;
  lane.x[at] = patch.normal.x();
  lane.y[at] = patch.normal.y();
  lane.z[at] = patch.normal.z();
  lane.level[at] = patch.level;
  lane.fits[at] = patch.fits;
  lane.is_seen[at] = patch.is_seen ? 1 : 0;
}

void Patches::add(const Patch& patch) {
  if (size_ == kMost) return;
  set(size_++, patch);
}

int Patches::join(const Patch& patch, const Eigen::Vector3f& point, float tolerance) {
  for (std::uint32_t i = 0; i < size_; ++i) {
    Patch plane = (*this)[i];
    if (plane.normal.dot(patch.normal) < kAgreement || plane.distanceTo(point) > tolerance) continue;
    plane.fits = std::min(plane.fits + 1, kMostFits);
    plane.is_seen = true;
    const float share = 1.0F / static_cast<float>(plane.fits);
    const Eigen::Vector3f mean = plane.normal + share * (patch.normal - plane.normal);
    plane.level = (plane.level + share * (patch.level - plane.level)) / mean.norm();
    plane.normal = mean.normalized();
    set(i, plane);
    return plane.fits;
  }
  add(patch);
  return patch.fits;
}

Patches& PatchCells::at(const Eigen::Vector3f& point) {
  std::uint32_t& number = cells_.at(point);
  if (number == 0) {
    patches_.emplace_back();
    places_.push_back(point);
    number = static_cast<std::uint32_t>(patches_.size());
  }
  return patches_[number - 1];
}

SharedPlanes::SharedPlanes(float cell_size, float tolerance, const Eigen::Vector3f& sensor, std::size_t returns,
                           const std::vector<KnownPlane>& known)
    : tolerance_(tolerance),
      sensor_(sensor),
      cells_(cell_size, returns / kReturnsPerCell),
      wide_cells_(std::max(kWide * cell_size, kLeastWide), returns / kReturnsPerWide) {
  for (const KnownPlane& plane : known) {
    wide_cells_.at(plane.place).add({plane.normal, plane.level, static_cast<int>(plane.fits)});
  }
}

std::optional<Eigen::Vector3f> SharedPlanes::normalAt(const Eigen::Vector3f& point) {
  Patches& wide = wide_cells_.at(point);
  if (const auto plane = wide.find(point, sensor_, tolerance_, kSure)) {
    wide.see(*plane);
    if (++served_ % kFitAgain == 0) return std::nullopt;
    return wide[*plane].normal;
  }
  const Patches& cell = cells_.at(point);
  const auto plane = cell.find(point, sensor_, tolerance_, 1);
  return plane ? std::optional(cell[*plane].normal) : std::nullopt;
}

void SharedPlanes::add(const Patch& patch, const Eigen::Vector3f& point) {
  Patches& wide = wide_cells_.at(point);
  if (const auto known = wide.find(point, sensor_, tolerance_, kSure)) {
    if (wide[*known].normal.dot(patch.normal) < kTurned) wide.doubt(*known);
  }
  if (wide.join(patch, point, tolerance_) < kSure) cells_.at(point).add(patch);
}

std::vector<KnownPlane> SharedPlanes::known() const {
  std::vector<KnownPlane> known;
  wide_cells_.forEach([&](const Eigen::Vector3f& place, const Patches& patches) {
    for (std::uint32_t i = 0; i < patches.size(); ++i) {
      const Patch plane = patches[i];
      if (plane.fits < kSure || !plane.is_seen) continue;
      known.push_back({place, plane.normal, plane.level, static_cast<float>(plane.fits)});
    }
  });
  known.shrink_to_fit();
  return known;
}

}  // namespace atom_map
