#include "atom_mapping/ros/map_snapshot.h"

namespace atom_mapping {

MapSnapshot takeSnapshot(const ScanServer& server) {
  MapSnapshot snapshot;
  snapshot.frame = server.mapFrame();
  snapshot.stamp = server.newest();
  snapshot.revision = server.revision();
  snapshot.atoms.reserve(server.read([](const atom_map::AtomMap& map) { return map.atoms().size() + 10000; }));
  server.read([&](const atom_map::AtomMap& map) {
    const bool has_variance = map.mode() == atom_map::Mode::kSignedDistance;
    snapshot.mode = map.mode();
    snapshot.radius = map.radius();
    snapshot.origin = map.origin();
    map.atoms().forEach([&](atom_map::ConstAtomRef atom) {
      snapshot.atoms.push_back({atom.center(), {atom.value(), has_variance ? atom.value(1) : 0.0F}});
    });
  });
  return snapshot;
}

atom_map::AtomMap toAtomMap(const MapSnapshot& snapshot) {
  atom_map::AtomMap map(snapshot.mode, static_cast<double>(snapshot.radius));
  map.anchor(snapshot.origin);
  for (const MapSnapshot::Atom& atom : snapshot.atoms) map.atoms().insert(atom.center, atom.values.data());
  return map;
}

}  // namespace atom_mapping
