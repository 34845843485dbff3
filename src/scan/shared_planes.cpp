#include "atom_mapping/scan/shared_planes.h"

#include <algorithm>
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

bool Patch::faces(const Eigen::Vector3f& sensor, const Eigen::Vector3f& point) const {
  const Eigen::Vector3f ray = sensor - point;
  const float depth = normal.dot(ray);
  return depth > 0.0F && depth * depth > kMinFacing * kMinFacing * ray.squaredNorm();
}

Patch* Patches::find(const Eigen::Vector3f& point, const Eigen::Vector3f& sensor, float tolerance, int least_fits) {
  Patch* found = nullptr;
  for (std::uint32_t i = 0; i < size_; ++i) {
    Patch& plane = planes_[i];
    const float distance = plane.distanceTo(point);
    if (distance >= tolerance || plane.fits < least_fits || !plane.faces(sensor, point)) continue;
    tolerance = distance;
    found = &plane;
  }
  return found;
}

void Patches::add(const Patch& patch) {
  if (size_ < planes_.size()) planes_[size_++] = patch;
}

int Patches::join(const Patch& patch, const Eigen::Vector3f& point, float tolerance) {
  for (std::uint32_t i = 0; i < size_; ++i) {
    Patch& plane = planes_[i];
    if (plane.normal.dot(patch.normal) < kAgreement || plane.distanceTo(point) > tolerance) continue;
    plane.fits = std::min(plane.fits + 1, kMostFits);
    plane.is_seen = true;
    const float share = 1.0F / static_cast<float>(plane.fits);
    plane.normal = (plane.normal + share * (patch.normal - plane.normal)).normalized();
    plane.level += share * (patch.level - plane.level);
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
  if (Patch* const plane = wide_cells_.at(point).find(point, sensor_, tolerance_, kSure)) {
    plane->is_seen = true;
    if (++served_ % kFitAgain == 0) return std::nullopt;
    return plane->normal;
  }
  const Patch* const patch = cells_.at(point).find(point, sensor_, tolerance_, 1);
  return patch != nullptr ? std::optional(patch->normal) : std::nullopt;
}

void SharedPlanes::add(const Patch& patch, const Eigen::Vector3f& point) {
  Patches& wide = wide_cells_.at(point);
  Patch* const known = wide.find(point, sensor_, tolerance_, kSure);
  if (known != nullptr && known->normal.dot(patch.normal) < kTurned) --known->fits;
  if (wide.join(patch, point, tolerance_) < kSure) cells_.at(point).add(patch);
}

std::vector<KnownPlane> SharedPlanes::known() const {
  std::vector<KnownPlane> known;
  wide_cells_.forEach([&](const Eigen::Vector3f& place, const Patches& patches) {
    for (const Patch& plane : patches) {
      if (plane.fits < kSure || !plane.is_seen) continue;
      known.push_back({place, plane.normal, plane.level, static_cast<float>(plane.fits)});
    }
  });
  known.shrink_to_fit();
  return known;
}

}  // namespace atom_map
