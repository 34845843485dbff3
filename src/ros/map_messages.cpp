#include "atom_mapping/ros/map_messages.h"

#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "atom_mapping/base/quantile.h"
#include "atom_mapping/query/occupancy.h"
#include "atom_mapping/ros/atom_colors.h"
#include "atom_mapping/ros/pose_conversion.h"

namespace atom_mapping {
namespace {

using Atom = MapSnapshot::Atom;
using visualization_msgs::Marker;

constexpr float kGlass = 0.15F;      // opacity of free atoms
constexpr double kTail = 0.01;       // share of the atoms, lowest and highest, that do not stretch the colours
constexpr float kMinHeight = 1e-3F;  // m

bool isSolid(const MapSnapshot& map, const Atom& atom, const PublishParameters& parameters) {
  if (map.mode == atom_map::Mode::kOccupancy)
    return atom_map::classify(atom.values[0]) == atom_map::Occupancy::kOccupied;
  return std::abs(static_cast<double>(atom.values[0])) < parameters.surface_threshold;
}

// An even choice of at most `count` elements.
void thinOut(std::vector<Atom>& atoms, std::size_t count) {
  const std::size_t size = atoms.size();
  if (size <= count) return;
  for (std::size_t i = 0; i < count; ++i) atoms[i] = atoms[i * size / count];
  atoms.resize(count);
}

// What a value of `color` makes of an atom: 0 to 1.
class ColorScale {
 public:
  ColorScale(const MapSnapshot& map, const std::vector<Atom>& atoms, AtomColor color)
      : color_(isKnown(map.mode, color) ? color : AtomColor::kHeight), radius_(map.radius) {
    if (color_ != AtomColor::kHeight || atoms.empty()) return;
    std::vector<float> heights;
    for (const Atom& atom : atoms) heights.push_back(atom.center.z());
    low_ = atom_map::quantile(heights, kTail);
    height_ = std::max(atom_map::quantile(heights, 1.0 - kTail) - low_, kMinHeight);
  }

  float operator()(const Atom& atom) const {
    switch (color_) {
      case AtomColor::kHeight:
        return (atom.center.z() - low_) / height_;
      case AtomColor::kOccupancy:
        return atom_map::probability(atom.values[0]);
      case AtomColor::kDistance:
        return 0.5F - 0.25F * atom.values[0] / radius_;
    }
    return 0.0F;
  }

 private:
  // A map of another mode than the node was started with may have been loaded.
  static bool isKnown(atom_map::Mode mode, AtomColor color) {
    return color != (mode == atom_map::Mode::kOccupancy ? AtomColor::kDistance : AtomColor::kOccupancy);
  }

  AtomColor color_;
  float radius_;
  float low_ = 0.0F;
  float height_ = 1.0F;
};

std_msgs::Header makeHeader(const MapSnapshot& map) {
  std_msgs::Header header;
  header.frame_id = map.frame;
  header.stamp = map.stamp;
  return header;
}

Marker makeSpheres(const MapSnapshot& map, std::vector<Atom> atoms, const PublishParameters& parameters,
                   float opacity) {
  thinOut(atoms, parameters.max_markers);
  Marker marker;
  marker.header = makeHeader(map);
  marker.type = Marker::SPHERE_LIST;
  marker.action = atoms.empty() ? Marker::DELETE : Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 2.0 * static_cast<double>(map.radius);
  const ColorScale scale(map, atoms, parameters.color);
  marker.points.reserve(atoms.size());
  marker.colors.reserve(atoms.size());
  for (const Atom& atom : atoms) {
    marker.points.push_back(toPoint(atom.center.cast<double>() + map.origin));
    marker.colors.push_back(colorOf(scale(atom)));
    marker.colors.back().a = opacity;
  }
  return marker;
}

Marker makeMarker(const MapSnapshot& map, const PublishParameters& parameters, bool solid) {
  std::vector<Atom> chosen;
  std::copy_if(map.atoms.begin(), map.atoms.end(), std::back_inserter(chosen),
               [&](const Atom& atom) { return isSolid(map, atom, parameters) == solid; });
  Marker marker = makeSpheres(map, std::move(chosen), parameters, solid ? 1.0F : kGlass);
  marker.ns = solid ? "atoms" : "free_atoms";
  return marker;
}

}  // namespace

Marker toOccupiedMarker(const MapSnapshot& map, const PublishParameters& parameters) {
  return makeMarker(map, parameters, true);
}

Marker toFreeMarker(const MapSnapshot& map, const PublishParameters& parameters) {
  return makeMarker(map, parameters, false);
}

sensor_msgs::PointCloud2 toAtomCloud(const MapSnapshot& map) {
  using sensor_msgs::PointField;
  constexpr auto kFloat = PointField::FLOAT32;
  sensor_msgs::PointCloud2 cloud;
  cloud.header = makeHeader(map);
  cloud.is_dense = 1;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  const bool occupancy = map.mode == atom_map::Mode::kOccupancy;
  if (occupancy) {
    modifier.setPointCloud2Fields(4, "x", 1, kFloat, "y", 1, kFloat, "z", 1, kFloat, "log_odds", 1, kFloat);
  } else {
    modifier.setPointCloud2Fields(5, "x", 1, kFloat, "y", 1, kFloat, "z", 1, kFloat, "signed_distance", 1, kFloat,
                                  "variance", 1, kFloat);
  }
  modifier.resize(map.atoms.size());
  std::uint8_t* at = cloud.data.data();
  for (const Atom& atom : map.atoms) {
    const Eigen::Vector3f center = (atom.center.cast<double>() + map.origin).cast<float>();
    std::memcpy(at, center.data(), 3 * sizeof(float));
    std::memcpy(at + 3 * sizeof(float), atom.values.data(), (occupancy ? 1 : 2) * sizeof(float));
    at += cloud.point_step;
  }
  return cloud;
}

}  // namespace atom_mapping
