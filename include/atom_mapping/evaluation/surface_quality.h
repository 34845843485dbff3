// How a map judges the space next to surfaces (paper V-C).
#pragma once

#include <cstdint>
#include <vector>

#include "atom_mapping/sim/coverage.h"
#include "atom_mapping/sim/scene.h"

namespace atom_map {

// Shares that the map calls free of the points within some distances of a surface, one entry a distance.
struct SurfaceQuality {
  std::vector<Share> q;  // Eq. (13): of those on the sensor's side
  std::vector<Share> f;  // of those on the solid side; less is better
};

// Monte Carlo, 40,000 points for each share, or fewer where hardly any point is that near; drawn from the seed. `epsilon`: the
// distances, m. The scene must be closed and its inside seen by the sensor.
SurfaceQuality measureSurfaceQuality(const Scene& scene, const std::vector<double>& epsilon, const AskOccupancy& ask,
                                     std::uint64_t seed);

// The same where a surface was seen: of points within the distances of a surface, on the normal through one of the rays'
// ends, drawn at random. `rays` with their normals; the scene may be open.
SurfaceQuality measureQualityAtReturns(const Scene& scene, const std::vector<ObservedRay>& rays,
                                       const std::vector<double>& epsilon, const AskOccupancy& ask, std::uint64_t seed);

// Standard deviation of the estimate that a share of independent draws is.
double standardError(const Share& share);

// From r/10 to 4r.
std::vector<double> distancesFromSurface(double radius);

}  // namespace atom_map
