#include "atom_mapping/ros/fit_to_limits.h"

#include <sstream>
#include <stdexcept>

#include "atom_mapping/map/forget.h"
#include "atom_mapping/map/map_limit.h"

namespace atom_mapping {

std::size_t fitToLimits(const std::string& fault, const atom_map::LimitParameters& limits, const Eigen::Vector3d& place,
                        atom_map::AtomMap& map) {
  const atom_map::MapLimit limit = atom_map::limitOf(limits);
  if (limit.holds(map.atoms())) return 0;
  map.atoms().shrink();  // so that a map which was saved within the limit is
  if (limit.holds(map.atoms())) return 0;
  if (limits.policy == atom_map::LimitPolicy::kForgetFarthest) return forgetFarthest(map, limit, place);
  std::ostringstream text;
  text << fault << ": its " << map.atoms().size() << " atoms (" << 1e-6 * map.atoms().bytes()
       << " MB) are more than limits/max_atoms " << limits.max_atoms << " and limits/max_megabytes "
       << limits.max_megabytes << " permit (0: no limit); raise them, or set limits/policy to forget_farthest";
  throw std::runtime_error(text.str());
}

}  // namespace atom_mapping
