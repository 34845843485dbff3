#include "atom_mapping/io/picture/light_atoms.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace atom_map {
namespace {

constexpr int kSkyRays = 48;
constexpr int kSunRays = 16;
constexpr float kSkyReach = 4.0F;   // m, what is farther away casts no shade
constexpr float kSunReach = 25.0F;  // m
constexpr float kSunSize = 0.06F;   // radius of the sun's disc, as the tangent of its angle; softens shadows
constexpr float kMostCells = 3e8F;

// Which cubic cells of space hold an atom.
class CellGrid {
 public:
  CellGrid(const std::vector<Eigen::Vector3f>& centers, float side) {
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& center : centers) box.extend(center);
    side_ = side;
    while (((box.sizes() / side_).array() + 3.0F).prod() > kMostCells) side_ *= 1.1F;
    low_ = box.min() - Eigen::Vector3f::Constant(side_);
    size_ = (box.sizes() / side_).array().cast<long>() + 3;
    filled_.resize(static_cast<std::size_t>(size_.prod()));
    for (const Eigen::Vector3f& center : centers) filled_[index(cellOf(center))] = true;
  }

  float side() const { return side_; }

  bool filled(const Eigen::Vector3f& point) const {
    const Cell cell = cellOf(point);
    return (cell >= 0).all() && (cell < size_).all() && filled_[index(cell)];
  }

 private:
  using Cell = Eigen::Array<long, 3, 1>;

  Cell cellOf(const Eigen::Vector3f& point) const { return ((point - low_) / side_).array().floor().cast<long>(); }
  std::size_t index(const Cell& cell) const {
    return static_cast<std::size_t>((cell.x() * size_.y() + cell.y()) * size_.z() + cell.z());
  }

  float side_;
  Eigen::Vector3f low_;
  Cell size_;
  std::vector<bool> filled_;
};

// Points spread evenly over the unit disc (Vogel's spiral).
Eigen::Vector2f discPoint(int i, int count) {
  constexpr float kGoldenAngle = 2.39996323F;
  const float radius = std::sqrt((static_cast<float>(i) + 0.5F) / static_cast<float>(count));
  const float angle = kGoldenAngle * static_cast<float>(i);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// Directions upwards, dense where a level surface gets most of its light.
std::vector<Eigen::Vector3f> skyDirections() {
  std::vector<Eigen::Vector3f> directions;
  for (int i = 0; i < kSkyRays; ++i) {
    const Eigen::Vector2f xy = discPoint(i, kSkyRays);
    directions.emplace_back(xy.x(), xy.y(), std::sqrt(1.0F - xy.squaredNorm()));
  }
  return directions;
}

std::vector<Eigen::Vector3f> sunDirections(const Eigen::Vector3f& sun) {
  const Eigen::Vector3f side = sun.unitOrthogonal();
  const Eigen::Vector3f up = sun.cross(side);
  std::vector<Eigen::Vector3f> directions;
  for (int i = 0; i < kSunRays; ++i) {
    const Eigen::Vector2f offset = kSunSize * discPoint(i, kSunRays);
    directions.push_back((sun + offset.x() * side + offset.y() * up).normalized());
  }
  return directions;
}

// How far one sees from an atom, on average over directions, as a share of `reach`.
float openness(const CellGrid& grid, const Eigen::Vector3f& center, const std::vector<Eigen::Vector3f>& directions,
               float reach) {
  float sum = 0.0F;
  for (const Eigen::Vector3f& direction : directions) {
    float range = 1.8F * grid.side();  // beyond the atom's own neighbours
    while (range < reach && !grid.filled(center + range * direction)) range += 0.7F * grid.side();
    sum += std::min(1.0F, range / reach);
  }
  return sum / static_cast<float>(directions.size());
}

}  // namespace

std::vector<float> lightAtoms(const std::vector<Eigen::Vector3f>& centers, float radius, const Eigen::Vector3f& sun) {
  const CellGrid grid(centers, 2.0F * radius);
  const std::vector<Eigen::Vector3f> sky_directions = skyDirections();
  const std::vector<Eigen::Vector3f> sun_directions = sunDirections(sun);
  std::vector<float> light;
  light.reserve(centers.size());
  for (const Eigen::Vector3f& center : centers) {
    light.push_back(0.5F * openness(grid, center, sky_directions, kSkyReach) +
                    0.5F * openness(grid, center, sun_directions, kSunReach));
  }
  return light;
}

}  // namespace atom_map
