#include "atom_mapping/surface/follow_surface.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_set>

#include "atom_mapping/base/parallel.h"
#include "atom_mapping/query/gaussian_process.h"
#include "atom_mapping/query/occupancy.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

// Choice: from its centre an occupied atom looks this far for the free one that the surface parts it from.
constexpr float kSeedReach = 4.0F;  // radii

// Cells that are looked at for each that the surface passes, at most: on a surface of little area in very fine cells, the
// ways between atoms would fill the memory before the first is known to be passed.
constexpr std::size_t kTakenPerPassed = 8;

class SurfaceSearch {
 public:
  SurfaceSearch(const AtomMap& map, const GaussianProcessParameters& parameters, float spacing,
                const SurfaceRequest& request)
      : map_(map),
        parameters_(parameters),
        request_(request),
        to_free_(map.mode() == Mode::kOccupancy ? -1.0F : 1.0F),
        spacing_(spacing),
        found_{Lattice(spacing), {}, {}} {}

  SampledSurface run() {
    for (std::vector<LatticeIndex> front = seeds(); !front.empty();) front = advance(front);
    return std::move(found_);
  }

 private:
  bool isFree(ConstAtomRef atom) const { return classify(map_, atom) == Occupancy::kFree; }

  // Cells on the way from each occupied atom to the free atom nearest to it.
  std::vector<LatticeIndex> seeds() {
    std::vector<LatticeIndex> cells;
    map_.atoms().forEach([&](ConstAtomRef atom) {
      if (isFree(atom)) return;
      const std::optional<Vector3f> free = nearestFree(atom.center());
      if (!free) return;
      const auto steps = static_cast<int>(std::ceil(2.0F * (*free - atom.center()).norm() / spacing_));
      for (int i = 0; i <= steps; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(steps);
        take(found_.lattice.cellOf(atom.center() + share * (*free - atom.center())), cells);
      }
    });
    return cells;
  }

  std::optional<Vector3f> nearestFree(const Vector3f& center) const {
    std::optional<Vector3f> nearest;
    float nearest_distance = std::numeric_limits<float>::infinity();
    map_.atoms().forEachWithin(center, kSeedReach * map_.radius(), [&](ConstAtomRef atom, float squared_distance) {
      if (!isFree(atom) || squared_distance >= nearest_distance) return;
      nearest = atom.center();
      nearest_distance = squared_distance;
    });
    return nearest;
  }

  // Evaluates the corners of cells, keeps those that the surface passes and returns their neighbours.
  std::vector<LatticeIndex> advance(const std::vector<LatticeIndex>& front) {
    std::vector<LatticeCell> cells;
    cells.reserve(front.size());
    for (const LatticeIndex& index : front) cells.push_back(found_.lattice.cell(index));
    evaluateNewNodes();
    std::vector<LatticeIndex> next;
    for (const LatticeCell& cell : cells) {
      if (!isPassed(cell)) continue;
      found_.cells.push_back(cell);
      for (int axis = 0; axis < 3; ++axis) {
        for (const int step : {-1, 1}) take(cell.index + step * LatticeIndex::Unit(axis), next);
      }
    }
    if (found_.cells.size() > request_.max_cells) throwTooMany();
    return next;
  }

  void take(const LatticeIndex& cell, std::vector<LatticeIndex>& cells) {
    if (!request_.box.isEmpty() && !request_.box.contains(map_.toMap(found_.lattice.center(cell)))) return;
    if (taken_.insert(cell).second) cells.push_back(cell);
    if (taken_.size() / kTakenPerPassed > request_.max_cells) throwTooMany();
  }

  [[noreturn]] void throwTooMany() const {
    throw std::invalid_argument("the surface passes more than " + std::to_string(request_.max_cells) +
                                " cells; ask for a smaller box or a coarser resolution");
  }

  void evaluateNewNodes() {
    const std::size_t first = found_.values.size();
    found_.values.resize(found_.lattice.size());
    parallelFor(found_.values.size() - first, request_.threads, [&] {
      return [&, process = GaussianProcess(map_, parameters_)](std::size_t begin, std::size_t end) mutable {
        for (std::size_t i = first + begin; i < first + end; ++i) {
          const Vector3f node = found_.lattice.position(static_cast<std::uint32_t>(i));
          const auto estimate = process.estimate(node, kSurfaceReach);
          found_.values[i] = estimate ? to_free_ * estimate->value : std::numeric_limits<float>::quiet_NaN();
        }
      };
    });
    if (request_.progress) request_.progress(found_.values.size());
  }

  // Zero is free, as it is to the contour.
  bool isPassed(const LatticeCell& cell) const {
    int free = 0;
    for (const std::uint32_t corner : cell.corners) {
      if (std::isnan(found_.values[corner])) return false;
      free += found_.values[corner] >= 0.0F ? 1 : 0;
    }
    return free > 0 && free < 8;
  }

  const AtomMap& map_;
  const GaussianProcessParameters& parameters_;
  const SurfaceRequest& request_;
  float to_free_;  // sign of what the regression estimates in free space
  float spacing_;
  SampledSurface found_;
  std::unordered_set<LatticeIndex, HashLatticeIndex> taken_;
};

}  // namespace

SampledSurface followSurface(const AtomMap& map, const GaussianProcessParameters& parameters, float spacing,
                             const SurfaceRequest& request) {
  return SurfaceSearch(map, parameters, spacing, request).run();
}

}  // namespace atom_map
