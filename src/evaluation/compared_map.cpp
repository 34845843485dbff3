#include "atom_mapping/evaluation/compared_map.h"

#include <memory>

#include "atom_mapping/baseline/octomap_mapper.h"
#include "atom_mapping/map/mapper.h"
#include "atom_mapping/query/occupancy_query.h"

namespace atom_map {
namespace {

// `classify` and `units` ask what the mapper's read() gives them.
template <class AnyMapper, class Classify, class Units>
ComparedMap compared(std::string name, const std::shared_ptr<AnyMapper>& mapper, Classify classify, Units units) {
  return {std::move(name),
          [mapper](const LidarScan& scan, const Pose& sensor) { return mapper->insertScan(scan, sensor); },
          [mapper, classify](const Eigen::Vector3d& point) {
            return mapper->read([&](const auto& map) { return classify(map, point); });
          },
          [mapper, units] { return mapper->read(units); }, [mapper] { mapper->reset(); }};
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
      [query](const AtomMap& /*map*/, const Eigen::Vector3d& point) { return (*query)(point); },
      [](const AtomMap& map) -> std::uint64_t { return map.atoms().size(); });
}

ComparedMap makeOctomap(const MappingParameters& parameters, const OctomapParameters& octomap) {
  return compared(
      "octomap", std::make_shared<OctomapMapper>(parameters, octomap),
      [](const OctomapBaseline& map, const Eigen::Vector3d& point) { return map.classify(point); },
      [](const OctomapBaseline& map) -> std::uint64_t { return map.tree().getNumLeafNodes(); });
}

}  // namespace atom_map
