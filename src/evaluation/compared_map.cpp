#include "atom_mapping/evaluation/compared_map.h"

#include <memory>

#include "atom_mapping/baseline/octomap_mapper.h"
#include "atom_mapping/map/mapper.h"
#include "atom_mapping/query/occupancy_query.h"

namespace atom_map {
namespace {

std::vector<MapUnit> atomsOf(const AtomMap& map) {
  std::vector<MapUnit> atoms;
  map.atoms().forEach([&](const ConstAtomRef& atom) {
    const double value = map.mode() == Mode::kOccupancy ? atom.value() : -atom.value();
    atoms.push_back({map.toMap(atom.center()), 2.0 * static_cast<double>(map.radius()), value});
  });
  return atoms;
}

std::vector<MapUnit> voxelsOf(const OctomapBaseline& map) {
  std::vector<MapUnit> voxels;
  for (auto leaf = map.tree().begin_leafs(); leaf != map.tree().end_leafs(); ++leaf) {
    voxels.push_back(
        {{leaf.getX(), leaf.getY(), leaf.getZ()}, leaf.getSize(), static_cast<double>(leaf->getLogOdds())});
  }
  return voxels;
}

// `log_odds`, `units` and `list_units` ask what the mapper's read() gives them.
template <class AnyMapper, class LogOdds, class Units, class ListUnits>
ComparedMap compared(std::string name, const std::shared_ptr<AnyMapper>& mapper, LogOdds log_odds, Units units,
                     ListUnits list_units) {
  const auto at = [mapper, log_odds](const Eigen::Vector3d& point) {
    return mapper->read([&](const auto& map) { return log_odds(map, point); });
  };
  return {std::move(name),
          [mapper](const LidarScan& scan, const Pose& sensor) { return mapper->insertScan(scan, sensor); },
          [at](const Eigen::Vector3d& point) { return classify(at(point)); },
          [mapper, units] { return mapper->read(units); },
          [mapper] { mapper->reset(); },
          at,
          [mapper, list_units] { return mapper->read(list_units); }};
}

}  // namespace

ComparedMap makeAtomMap(MappingParameters parameters, Mode mode) {
  parameters.mode = mode;
  const auto mapper = std::make_shared<Mapper>(parameters);
  const auto query = mapper->read([&](const AtomMap& map) {
    return std::make_shared<OccupancyQuery>(map, parameters.gaussian_process);  // the map stays where it is
  });
  return compared(
      mode == Mode::kOccupancy ? "atom_occupancy" : "atom_signed_distance", mapper,
      [query](const AtomMap& map, const Eigen::Vector3d& point) { return query->logOdds(map.toLocal(point)); },
      [](const AtomMap& map) -> std::uint64_t { return map.atoms().size(); }, atomsOf);
}

ComparedMap makeOctomap(const MappingParameters& parameters, const OctomapParameters& octomap) {
  return compared(
      octomap.prune ? "octomap_pruned" : "octomap", std::make_shared<OctomapMapper>(parameters, octomap),
      [](const OctomapBaseline& map, const Eigen::Vector3d& point) { return map.logOdds(point); },
      [](const OctomapBaseline& map) -> std::uint64_t { return map.tree().getNumLeafNodes(); }, voxelsOf);
}

std::vector<ComparedMap> makeComparedMaps(const MappingParameters& parameters, double voxel, const MoreOctomaps& more) {
  std::vector<ComparedMap> maps{makeAtomMap(parameters, Mode::kOccupancy),
                                makeAtomMap(parameters, Mode::kSignedDistance),
                                makeOctomap(parameters, {voxel, false})};
  if (more.pruned) maps.push_back(makeOctomap(parameters, {voxel, true}));
  if (more.every_return) {
    MappingParameters unthinned = parameters;
    unthinned.scan.thinning = 0.0;
    maps.push_back(makeOctomap(unthinned, {voxel, false}));
    maps.back().name = "octomap_every_return";
  }
  return maps;
}

}  // namespace atom_map
