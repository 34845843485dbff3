// Maps as large as a town's, made quickly: copies of the hall as a drive of 40 scans mapped it, side by side.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "atom_mapping/evaluation/growth.h"
#include "atom_mapping/map/mapper.h"
#include "draw.h"
#include "simulated.h"

namespace atom_map {

// A ray of the drive, in the map's local frame.
struct MapRay {
  Eigen::Vector3f sensor;
  Eigen::Vector3f end;

  Eigen::Vector3f at(float share) const { return sensor + share * (end - sensor); }
};

class LargeMap {
 public:
  static constexpr double kSpacing = 100.0;  // m, between copies; the hall is shorter

  LargeMap(Mode mode, std::size_t least_atoms) : map_(mode, MappingParameters().radius) {
    parameters_.mode = mode;
    const Drive drive = makeDrive("hall", 40);
    Mapper mapper(parameters_);
    for (std::size_t i = 0; i < drive.scans.size(); ++i) mapper.insertScan(drive.scans[i], drive.poses[i]);
    mapper.read([&](const AtomMap& hall) {
      keepRays(drive, hall);
      copies_ = (least_atoms + hall.atoms().size() - 1) / hall.atoms().size();
      for (std::size_t i = 0; i < copies_; ++i) insertCopy(hall, i);
    });
  }

  const AtomMap& map() const { return map_; }
  const MappingParameters& parameters() const { return parameters_; }

  // Rays of the drive, in any of the copies. At least `least_range` m long, from a sensor's place to a return.
  std::vector<MapRay> drawRays(std::size_t count, float least_range, std::uint64_t seed) const {
    Random random(seed);
    std::vector<MapRay> rays;
    while (rays.size() < count) {
      const MapRay& ray = rays_[drawIndex(random, rays_.size())];
      if ((ray.end - ray.sensor).norm() < least_range) continue;
      const Eigen::Vector3f place = placeOf(drawIndex(random, copies_));
      rays.push_back({ray.sensor + place, ray.end + place});
    }
    return rays;
  }

  // Anywhere on the drive's rays, in any of the copies.
  std::vector<Eigen::Vector3f> drawPoints(std::size_t count, std::uint64_t seed) const {
    Random random(seed);
    std::vector<Eigen::Vector3f> points;
    for (const MapRay& ray : drawRays(count, 0.0F, seed + 1)) points.push_back(ray.at(random.uniform()));
    return points;
  }

 private:
  void keepRays(const Drive& drive, const AtomMap& hall) {
    for (std::size_t i = 0; i < drive.scans.size(); ++i) {
      const Eigen::Vector3f sensor = hall.toLocal(drive.poses[i].translation());
      for (const Eigen::Vector3f& point : drive.scans[i].points) {
        const auto range = static_cast<double>(point.norm());
        if (range < parameters_.scan.min_range || range > parameters_.scan.max_range) continue;
        rays_.push_back({sensor, hall.toLocal(drive.poses[i] * point.cast<double>())});
      }
    }
  }

  Eigen::Vector3f placeOf(std::size_t copy) const { return placeOfCopy(copy, copies_, kSpacing).cast<float>(); }

  void insertCopy(const AtomMap& hall, std::size_t copy) {
    const bool has_variance = map_.mode() == Mode::kSignedDistance;
    hall.atoms().forEach([&](ConstAtomRef atom) {
      const std::array<float, 2> values{atom.value(), has_variance ? atom.value(1) : 0.0F};
      map_.atoms().insert(atom.center() + placeOf(copy), values.data());
    });
  }

  MappingParameters parameters_;
  AtomMap map_;
  std::size_t copies_ = 0;
  std::vector<MapRay> rays_;
};

}  // namespace atom_map
