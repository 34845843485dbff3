#include "atom_mapping/scan/normals.h"

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

constexpr float kNotThin = std::numeric_limits<float>::infinity();

// Whether a return lies on the plane of another one's surface, and on the side of it that the sensor sees.
bool isOnPlane(const SurfacePoint& surface, const Eigen::Vector3f& point, float noise) {
  constexpr float kCurvature = 0.01F;  // distance from the plane that is tolerated, over the distance from its point
  const Eigen::Vector3f offset = point - surface.position;
  return std::abs(surface.normal.dot(offset)) < 2.0F * noise + kCurvature * offset.norm() &&
         -surface.normal.dot(point) > kMinFacing * point.norm();
}

}  // namespace

std::vector<SurfacePoint> estimateSurface(const FilteredScan& scan, double radius, const ScanParameters& parameters,
                                          NormalReport& report) {
  const RangeImage image(scan.points, parameters.horizontal_resolution * kDegree,
                         parameters.vertical_resolution * kDegree);
  const auto noise = static_cast<float>(parameters.range_noise);
  const auto thin_width = static_cast<float>(parameters.thin_width);
  const auto cell_size = static_cast<float>(parameters.shared_normals * radius);
  std::optional<CellTable<std::uint32_t>> patches;  // one more than the place of a cell's first plane, or 0
  if (cell_size > 0.0F) patches.emplace(cell_size);
  std::vector<SurfacePoint> surface;
  surface.reserve(scan.rays.size());
  for (const std::uint32_t ray : scan.rays) {
    const Eigen::Vector3f& point = scan.points[ray];
    std::uint32_t unused = 0;
    std::uint32_t& patch = patches ? patches->at(point) : unused;
    if (patch > 0 && isOnPlane(surface[patch - 1], point, noise)) {
      surface.push_back({point, surface[patch - 1].normal, kNotThin});
      ++report.shared;
      continue;
    }
    const Normal normal = estimateNormal(collectNeighbors(image, ray, point, parameters), -point.normalized(), noise);
    const float half_width = halfWidth(image, ray, point, thin_width);
    surface.push_back({point, normal.direction, half_width});
    if (patch == 0 && normal.fit == Fit::kPlane && half_width == kNotThin) patch = surface.size();
    report.from_line += normal.fit == Fit::kLine ? 1 : 0;
    report.from_ray += normal.fit == Fit::kNone ? 1 : 0;
  }
  return surface;
}

}  // namespace atom_map
