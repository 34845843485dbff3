#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "atom_mapping/base/cell_table.h"
#include "atom_mapping/base/known_plane.h"
#include "atom_mapping/base/lanes.h"

namespace atom_map {

// A plane that was fitted to a return, in the frame of the points.
struct Patch {
  Eigen::Vector3f normal;  // unit, turned towards the sensor
  float level;             // m, along the normal from the origin
  int fits = 1;            // how many agree on it
  bool is_seen = false;    // whether returns of the scan at hand lie on it

  float distanceTo(const Eigen::Vector3f& point) const;  // m
};

// The first planes of a cell, four of which are compared with a point at once.
// Choice: no more than six. The more there are, the more returns of cluttered places lie on one by chance.
class Patches {
 public:
  static constexpr std::uint32_t kMost = 6;

  // The number of the plane that a return lies on, the nearest of those within the tolerance (m) that so many fits agree on.
  std::optional<std::uint32_t> find(const Eigen::Vector3f& point, const Eigen::Vector3f& sensor, float tolerance,
                                    int least_fits) const;

  std::uint32_t size() const { return size_; }
  Patch operator[](std::uint32_t i) const;
  void see(std::uint32_t i) { lanes_[i / kLane].is_seen[i % kLane] = 1; }  // a return lies on it
  void doubt(std::uint32_t i) { --lanes_[i / kLane].fits[i % kLane]; }     // one agrees less

  // Dropped where the cell has enough.
  void add(const Patch& patch);

  // Joins one that was fitted to the point with one that agrees with it, or adds it. Returns how many agree on it now.
  int join(const Patch& patch, const Eigen::Vector3f& point, float tolerance);

 private:
  void set(std::uint32_t i, const Patch& patch);

  struct Lane {
    Floats x{}, y{}, z{};                                              // of the normals
    Floats level = Floats{} + std::numeric_limits<float>::infinity();  // no point lies on those that are not there
    Bits fits{};
    Bits is_seen{};
  };
  std::array<Lane, (kMost + kLane - 1) / kLane> lanes_;
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
