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

std::vector<SurfacePoint> estimateSurface(const FilteredScan& scan, const Eigen::Isometry3f& pose, double radius,
                                          const ScanParameters& parameters, std::vector<KnownPlane>& known,
                                          NormalReport& report) {
  const RangeImage image(scan.points, parameters.horizontal_resolution * kDegree,
                         parameters.vertical_resolution * kDegree);
  const auto noise = static_cast<float>(parameters.range_noise);
  const auto thin_width = static_cast<float>(parameters.thin_width);
  const auto cell_size = static_cast<float>(parameters.shared_normals * radius);
  std::optional<SharedPlanes> planes;
  if (cell_size > 0.0F) {
    planes.emplace(cell_size, 2.0F * noise + kCurvature * cell_size, pose.translation(), scan.rays.size(), known);
  }
  std::vector<SurfacePoint> surface;
  surface.reserve(scan.rays.size());
  for (const std::uint32_t ray : scan.rays) {
    const Eigen::Vector3f& point = scan.points[ray];
    const Eigen::Vector3f place = pose * point;
    if (const auto normal = planes ? planes->normalAt(place) : std::nullopt) {
      surface.push_back({place, *normal, kNotThin});
      ++report.shared;
      continue;
    }
    const Neighborhood neighbors = collectNeighbors(image, scan.points, ray, parameters);
    const Normal fitted = estimateNormal(neighbors, -point.normalized(), noise);
    const Eigen::Vector3f normal = pose.linear() * fitted.direction;
    const float half_width = halfWidth(image, ray, point, thin_width);
    surface.push_back({place, normal, half_width});
    if (planes && fitted.fit == Fit::kPlane && half_width == kNotThin) {
      planes->add({normal, normal.dot(place) + fitted.offset}, place);
    }
    report.from_line += fitted.fit == Fit::kLine ? 1 : 0;
    report.from_ray += fitted.fit == Fit::kNone ? 1 : 0;
  }
  if (planes) known = planes->known();
  return surface;
}

}  // namespace atom_map
