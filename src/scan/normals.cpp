#include "atom_mapping/scan/normals.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "atom_mapping/base/angles.h"
#include "atom_mapping/base/cell_table.h"
#include "atom_mapping/scan/estimate_normal.h"
#include "atom_mapping/scan/half_width.h"
#include "atom_mapping/scan/neighborhood.h"
#include "atom_mapping/scan/range_image.h"

namespace atom_map {
namespace {

constexpr float kCurvature = 0.005F;  // distance from a cell's plane that is tolerated, over the cell's side
constexpr float kNotThin = std::numeric_limits<float>::infinity();

// A plane that was fitted to a return.
struct Patch {
  Eigen::Vector3f normal;  // unit, turned towards the sensor
  float distance;          // m, of the sensor from the plane

  // How far off it a return lies, in metres; infinite for one that faces the sensor on its other side or too obliquely.
  float distanceTo(const Eigen::Vector3f& point) const {
    const float depth = -normal.dot(point);  // of the return, square to the plane
    const bool faces = depth > 0.0F && depth * depth > kMinFacing * kMinFacing * point.squaredNorm();
    return faces ? std::abs(distance - depth) : std::numeric_limits<float>::infinity();
  }
};

// The first planes of a cell.
struct Patches {
  std::array<Patch, 3> planes;
  std::uint32_t size = 0;

  // The plane that a return lies on, the nearest of those within the tolerance.
  const Patch* find(const Eigen::Vector3f& point, float tolerance) const {
    const Patch* found = nullptr;
    for (std::uint32_t i = 0; i < size; ++i) {
      const float distance = planes[i].distanceTo(point);
      if (distance >= tolerance) continue;
      tolerance = distance;
      found = &planes[i];
    }
    return found;
  }

  void add(const Patch& patch) {
    if (size < planes.size()) planes[size++] = patch;
  }
};

// Cell by cell.
class SharedPlanes {
 public:
  // `cell_size` in metres; 0: none is shared.
  explicit SharedPlanes(float cell_size) {
    if (cell_size > 0.0F) cells_.emplace(cell_size);
  }

  // Of the cell that holds the point. Valid until the next call.
  Patches& near(const Eigen::Vector3f& point) {
    if (!cells_) return none_ = Patches();
    std::uint32_t& number = cells_->at(point);  // counted from 1
    if (number == 0) {
      patches_.emplace_back();
      number = static_cast<std::uint32_t>(patches_.size());
    }
    return patches_[number - 1];
  }

 private:
  std::optional<CellTable<std::uint32_t>> cells_;
  std::vector<Patches> patches_;
  Patches none_;
};

}  // namespace

std::vector<SurfacePoint> estimateSurface(const FilteredScan& scan, double radius, const ScanParameters& parameters,
                                          NormalReport& report) {
  const RangeImage image(scan.points, parameters.horizontal_resolution * kDegree,
                         parameters.vertical_resolution * kDegree);
  const auto noise = static_cast<float>(parameters.range_noise);
  const auto thin_width = static_cast<float>(parameters.thin_width);
  const auto cell_size = static_cast<float>(parameters.shared_normals * radius);
  const float tolerance = 2.0F * noise + kCurvature * cell_size;
  SharedPlanes planes(cell_size);
  std::vector<SurfacePoint> surface;
  surface.reserve(scan.rays.size());
  for (const std::uint32_t ray : scan.rays) {
    const Eigen::Vector3f& point = scan.points[ray];
    Patches& patches = planes.near(point);
    if (const Patch* const patch = patches.find(point, tolerance)) {
      surface.push_back({point, patch->normal, kNotThin});
      ++report.shared;
      continue;
    }
    const Neighborhood neighbors = collectNeighbors(image, scan.points, ray, parameters);
    const Normal normal = estimateNormal(neighbors, -point.normalized(), noise);
    const float half_width = halfWidth(image, ray, point, thin_width);
    surface.push_back({point, normal.direction, half_width});
    if (normal.fit == Fit::kPlane && half_width == kNotThin) {
      patches.add({normal.direction, -normal.direction.dot(point) - normal.offset});
    }
    report.from_line += normal.fit == Fit::kLine ? 1 : 0;
    report.from_ray += normal.fit == Fit::kNone ? 1 : 0;
  }
  return surface;
}

}  // namespace atom_map
