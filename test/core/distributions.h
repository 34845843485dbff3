// Where atoms may lie: the cases that every search of the atom tree has to stand.
#pragma once

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include "draw.h"

namespace atom_map {

constexpr float kCell = 0.5F;  // m, of the trees under test

struct Distribution {
  std::string name;
  std::vector<Eigen::Vector3f> centers;
};

inline std::ostream& operator<<(std::ostream& out, const Distribution& d) {
  return out << d.name;
}

using Centers = std::vector<Eigen::Vector3f>;

template <class DrawCenter>
Centers drawMany(std::size_t count, DrawCenter&& draw_center) {
  Centers centers(count);
  for (Eigen::Vector3f& center : centers) center = draw_center();
  return centers;
}

// Groups of atoms much nearer to one another than to other groups.
inline Centers drawClusters(Random& random) {
  const Centers middles = drawMany(20, [&] { return drawWithin(random, 50.0F); });
  return drawMany(3000, [&]() -> Eigen::Vector3f {
    const Eigen::Vector3f& middle = middles[drawIndex(random, middles.size())];
    return middle + drawGaussianVector(random);
  });
}

// More atoms at a place than a leaf's capacity, and more than one in a cell.
inline Centers drawDuplicates(Random& random) {
  const Centers places = drawMany(40, [&] { return drawWithin(random, 5.0F); });
  return drawMany(2500, [&] { return places[drawIndex(random, places.size())]; });
}

inline Eigen::Vector3f drawInPlane(Random& random) {
  Eigen::Vector3f point = drawWithin(random, 40.0F);
  point.z() = 0.0F;
  return point;
}

inline Centers gridOnCellBorders() {
  Centers centers;
  for (int x = -6; x <= 6; ++x) {
    for (int y = -6; y <= 6; ++y) {
      for (int z = -6; z <= 6; ++z) centers.push_back(kCell * Eigen::Vector3f(x, y, z));
    }
  }
  return centers;
}

inline Centers sortedAlongX(Centers centers) {
  std::sort(centers.begin(), centers.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
  return centers;
}

inline Centers moved(Centers centers, const Eigen::Vector3f& by) {
  for (Eigen::Vector3f& center : centers) center += by;
  return centers;
}

inline std::vector<Distribution> distributions() {
  Random random(11);
  const auto uniform = [&](std::size_t count, float half) {
    return drawMany(count, [&] { return drawWithin(random, half); });
  };
  const Eigen::Vector3f line(1.0F, -0.3F, 0.02F);
  std::vector<Distribution> all = {
      {"uniform", uniform(4000, 20.0F)},
      {"dense", uniform(4000, 1.0F)},
      {"clustered", drawClusters(random)},
      {"planar", drawMany(3000, [&] { return drawInPlane(random); })},
      {"collinear", drawMany(2000, [&]() -> Eigen::Vector3f { return draw(random, -500.0F, 500.0F) * line; })},
      {"sorted", sortedAlongX(uniform(3000, 30.0F))},
      {"duplicates", drawDuplicates(random)},
      {"far_away", moved(uniform(3000, 20.0F), {1e5F, -1e5F, 300.0F})},
      {"negative", moved(uniform(3000, 20.0F), {-25.0F, -25.0F, -25.0F})},
      {"cell_borders", gridOnCellBorders()},
  };
  for (std::size_t count = 0; count <= 5; ++count) all.push_back({"count_" + std::to_string(count), uniform(count, 2)});
  return all;
}

}  // namespace atom_map
