#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "atom_mapping/base/cell_table.h"
#include "atom_mapping/base/known_plane.h"

namespace atom_map {

// A plane that was fitted to a return, in the frame of the points.
struct Patch {
  Eigen::Vector3f normal;  // unit, turned towards the sensor
  float level;             // m, along the normal from the origin
  int fits = 1;            // how many agree on it
  bool is_seen = false;    // whether returns of the scan at hand lie on it

  float distanceTo(const Eigen::Vector3f& point) const;  // m

  // Whether a return at the point can lie on this side of it: not if it would be seen from behind or too obliquely.
  bool faces(const Eigen::Vector3f& sensor, const Eigen::Vector3f& point) const;
};

// The first planes of a cell.
class Patches {
 public:
  // The plane that a return lies on, the nearest of those within the tolerance (m) that so many fits agree on; nullptr if
  // there is none. Valid until the next change.
  Patch* find(const Eigen::Vector3f& point, const Eigen::Vector3f& sensor, float tolerance, int least_fits);

  // Dropped where the cell has enough.
  void add(const Patch& patch);

  // Joins one that was fitted to the point with one that agrees with it, or adds it. Returns how many agree on it now.
  int join(const Patch& patch, const Eigen::Vector3f& point, float tolerance);

  const Patch* begin() const { return planes_.data(); }
  const Patch* end() const { return planes_.data() + size_; }

 private:
  std::array<Patch, 6> planes_;
  std::uint32_t size_ = 0;
};

// Cell by cell.
class PatchCells {
 public:
  // `cell_size` in metres.
  PatchCells(float cell_size, std::size_t expected_cells) : cells_(cell_size, expected_cells) {}

  // Of the cell that holds the point. Valid until the next call.
  Patches& at(const Eigen::Vector3f& point);

  // Calls visit(a point of the cell, its Patches).
  template <class Visit>
  void forEach(Visit&& visit) const {
    for (std::size_t i = 0; i < patches_.size(); ++i) visit(places_[i], patches_[i]);
  }

 private:
  CellTable<std::uint32_t> cells_;  // numbers counted from 1
  std::vector<Patches> patches_;
  std::vector<Eigen::Vector3f> places_;  // a point of each cell
};

// The planes that several returns lie on: of the same cell, and of a wide one where several fits agree, as they do on a flat wall
// and not on a curved one. What a scan finds of the latter serves the next one too.
class SharedPlanes {
 public:
  // `cell_size` and `tolerance`, the greatest distance of a return from its plane, in metres. `known`: of the scan before, in
  // the same frame.
  SharedPlanes(float cell_size, float tolerance, const Eigen::Vector3f& sensor, std::size_t returns,
               const std::vector<KnownPlane>& known);

  // The normal of a plane that the return lies on; nothing where it should have one of its own fitted.
  // Choice: that is asked for now and then of planes that are known, so that they grow truer from scan to scan and those
  // that have turned are noticed.
  std::optional<Eigen::Vector3f> normalAt(const Eigen::Vector3f& point);

  // A plane that was fitted to the return.
  void add(const Patch& patch, const Eigen::Vector3f& point);

  // Those that several fits agree on and that returns of this scan lie on.
  std::vector<KnownPlane> known() const;

 private:
  float tolerance_;
  Eigen::Vector3f sensor_;
  PatchCells cells_;
  PatchCells wide_cells_;
  std::uint32_t served_ = 0;  // returns that lie on known planes
};

}  // namespace atom_map
