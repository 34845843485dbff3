// Stage 2: surface normals. They decide how true the map is, since atoms are placed tangent to them.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "atom_mapping/base/known_plane.h"
#include "atom_mapping/base/parameters.h"
#include "atom_mapping/base/types.h"
#include "atom_mapping/scan/filter.h"

namespace atom_map {

struct NormalReport {
  std::uint32_t shared = 0;     // returns that lie on the surface of another one, and have its normal
  std::uint32_t from_line = 0;  // all neighbours on one line: the normal is square to it, else as the ray
  std::uint32_t from_ray = 0;   // no neighbours that agree: the normal is the ray's direction
};

// A surface point for each of the scan's rays, in its order. `pose`: sensor frame to that of the surface points, the same for
// all scans; `radius` (m) is that of the atoms; `known`: of the scan before, and then of this one.
//
// A VLP-16's rings lie far apart, so that the nearest points are all on one ring, and a plane through a line is
// arbitrary. Choice: the neighbours come from the range image, some from each of five rings.
// Choice: returns that lie on a plane which was fitted to another one of their cell, of scan/shared_normals radii, share its
// normal, which also tests it; and so do those of a cell eight times as wide (and 3 m at least) on a plane that three fits
// agree on, of this scan or the one before. That is flat, and the mean of the fits is truer than each. Only the others have
// a normal of their own.
std::vector<SurfacePoint> estimateSurface(const FilteredScan& scan, const Eigen::Isometry3f& pose, double radius,
                                          const ScanParameters& parameters, std::vector<KnownPlane>& known,
                                          NormalReport& report);

}  // namespace atom_map
