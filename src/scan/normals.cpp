#include "atom_mapping/scan/normals.h"

#include <limits>
#include <optional>

#include "atom_mapping/base/angles.h"
#include "atom_mapping/scan/estimate_normal.h"
#include "atom_mapping/scan/half_width.h"
#include "atom_mapping/scan/neighborhood.h"
#include "atom_mapping/scan/range_image.h"
#include "atom_mapping/scan/shared_planes.h"

namespace atom_map {
namespace {

constexpr float kCurvature = 0.005F;  // distance from a cell's plane that is tolerated, over the cell's side
constexpr float kNotThin = std::numeric_limits<float>::infinity();

}  // namespace

std::vector<SurfacePoint> estimateSurface(const FilteredScan& scan, double radius, const ScanParameters& parameters,
                                          NormalReport& report) {
  const RangeImage image(scan.points, parameters.horizontal_resolution * kDegree,
                         parameters.vertical_resolution * kDegree);
  const auto noise = static_cast<float>(parameters.range_noise);
  const auto thin_width = static_cast<float>(parameters.thin_width);
  const auto cell_size = static_cast<float>(parameters.shared_normals * radius);
  std::optional<SharedPlanes> planes;
  if (cell_size > 0.0F) planes.emplace(cell_size, 2.0F * noise + kCurvature * cell_size, scan.rays.size());
  std::vector<SurfacePoint> surface;
  surface.reserve(scan.rays.size());
  for (const std::uint32_t ray : scan.rays) {
    const Eigen::Vector3f& point = scan.points[ray];
    if (const auto normal = planes ? planes->normalAt(point) : std::nullopt) {
      surface.push_back({point, *normal, kNotThin});
      ++report.shared;
      continue;
    }
    const Neighborhood neighbors = collectNeighbors(image, scan.points, ray, parameters);
    const Normal normal = estimateNormal(neighbors, -point.normalized(), noise);
    const float half_width = halfWidth(image, ray, point, thin_width);
    surface.push_back({point, normal.direction, half_width});
    if (planes && normal.fit == Fit::kPlane && half_width == kNotThin) {
      planes->add({normal.direction, -normal.direction.dot(point) - normal.offset}, point);
    }
    report.from_line += normal.fit == Fit::kLine ? 1 : 0;
    report.from_ray += normal.fit == Fit::kNone ? 1 : 0;
  }
  return surface;
}

}  // namespace atom_map
