#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "atom_mapping/base/cell_table.h"

namespace atom_map {

// A plane that was fitted to a return.
struct Patch {
  Eigen::Vector3f normal;  // unit, turned towards the sensor
  float distance;          // m, of the sensor from the plane
  int fits = 1;            // how many agree on it

  // How far off it a return lies, in metres; infinite for one that faces the sensor on its other side or too obliquely.
  float distanceTo(const Eigen::Vector3f& point) const;
};

// The first planes of a cell.
class Patches {
 public:
  // The plane that a return lies on, the nearest of those within the tolerance (m).
  const Patch* find(const Eigen::Vector3f& point, float tolerance) const;

  // Dropped where the cell has enough.
  void add(const Patch& patch);

  // Joins one that was fitted to the point with one that agrees with it, or adds it.
  void join(const Patch& patch, const Eigen::Vector3f& point, float tolerance);

  bool isEmpty() const { return size_ == 0; }

 private:
  std::array<Patch, 3> planes_;
  std::uint32_t size_ = 0;
};

// Cell by cell.
class PatchCells {
 public:
  // `cell_size` in metres.
  PatchCells(float cell_size, std::size_t expected_cells) : cells_(cell_size, expected_cells) {}

  // Of the cell that holds the point. Valid until the next call.
  Patches& at(const Eigen::Vector3f& point);

 private:
  CellTable<std::uint32_t> cells_;  // numbers counted from 1
  std::vector<Patches> patches_;
};

// The planes of one scan that other returns lie on too: returns of the same cell, and of a wide one where several fits agree,
// as they do on a flat wall and not on a curved one.
class SharedPlanes {
 public:
  // `cell_size` and `tolerance`, the greatest distance of a return from its plane, in metres.
  SharedPlanes(float cell_size, float tolerance, std::size_t returns);

  // The normal of a plane that the return lies on.
  std::optional<Eigen::Vector3f> normalAt(const Eigen::Vector3f& point);

  // A plane that was fitted to the return.
  void add(const Patch& patch, const Eigen::Vector3f& point);

 private:
  float tolerance_;
  PatchCells cells_;
  PatchCells wide_cells_;
};

}  // namespace atom_map
