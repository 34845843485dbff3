#include "atom_mapping/evaluation/surface_quality.h"

#include <cmath>

#include "atom_mapping/base/random.h"

namespace atom_map {
namespace {

constexpr std::uint64_t kPoints = 40000;
constexpr std::uint64_t kMostDraws =
    500 * kPoints;  // of surfaces so thin, or returns so far from them, that few are near

Eigen::Vector3d drawIn(const Eigen::AlignedBox3d& box, Random& random) {
  Eigen::Vector3d share;
  for (double& coordinate : share) coordinate = static_cast<double>(random.uniform());
  return box.min() + share.cwiseProduct(box.sizes());
}

// Asks for the points that draw() gives, as many on each side of the surface, that lie within a distance of it.
template <class Draw>
void measure(const Scene& scene, double distance, const AskOccupancy& ask, Draw draw, SurfaceQuality& quality) {
  Share& q = quality.q.emplace_back();
  Share& f = quality.f.emplace_back();
  for (std::uint64_t i = 0; i < kMostDraws && (q.whole < kPoints || f.whole < kPoints); ++i) {
    const Eigen::Vector3d point = draw();
    const double depth = scene.signedDistance(point);
    Share& side = depth > 0.0 ? q : f;
    if (std::abs(depth) < distance && side.whole < kPoints) side.count(ask(point) == Occupancy::kFree);  // Eq. (13)
  }
}

}  // namespace

SurfaceQuality measureSurfaceQuality(const Scene& scene, const std::vector<double>& epsilon, const AskOccupancy& ask,
                                     std::uint64_t seed) {
  SurfaceQuality quality;
  Random random(seed);
  for (const double distance : epsilon) {
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(distance);
    const Eigen::AlignedBox3d box(scene.bounds().min() - margin, scene.bounds().max() + margin);
    measure(
        scene, distance, ask, [&] { return drawIn(box, random); }, quality);
  }
  return quality;
}

SurfaceQuality measureQualityAtReturns(const Scene& scene, const std::vector<ObservedRay>& rays,
                                       const std::vector<double>& epsilon, const AskOccupancy& ask,
                                       std::uint64_t seed) {
  constexpr double kMargin = 1.2;  // of the distance: noise has moved the ends
  SurfaceQuality quality;
  if (rays.empty()) return quality;
  Random random(seed);
  const auto draw = [&] { return static_cast<double>(random.uniform()); };
  for (const double distance : epsilon) {
    const auto draw_point = [&]() -> Eigen::Vector3d {
      const ObservedRay& ray = rays[static_cast<std::size_t>(draw() * static_cast<double>(rays.size()))];
      return ray.end + kMargin * distance * (2.0 * draw() - 1.0) * ray.normal.value();
    };
    measure(scene, distance, ask, draw_point, quality);
  }
  return quality;
}

double standardError(const Share& share) {
  if (share.whole == 0) return 0.0;
  return std::sqrt(share.value() * (1.0 - share.value()) / static_cast<double>(share.whole));
}

std::vector<double> distancesFromSurface(double radius) {
  std::vector<double> distances;
  for (const double radii : {0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 4.0}) distances.push_back(radii * radius);
  return distances;
}

}  // namespace atom_map
