#include "atom_mapping/map/map_copy.h"

#include <algorithm>

namespace atom_map {
namespace {

// Memory is made ready, page by page, before the map is held: that takes longer than to copy.
constexpr std::size_t kGrowth = 50000;  // atoms that may come meanwhile

void copyAtoms(const AtomTree& atoms, std::size_t column_count, MapCopy& copy) {
  for (std::size_t c = 0; c < column_count; ++c) copy.columns[c].resize(std::max(copy.size(), atoms.size()));
  std::array<float*, 5> at{};
  for (std::size_t c = 0; c < column_count; ++c) at[c] = copy.columns[c].data();
  atoms.forEachBlock([&](const AtomBlock& block) {
    for (std::size_t c = 0; c < column_count; ++c) {
      at[c] = std::copy_n(block.channel(static_cast<int>(c)), block.size(), at[c]);
    }
  });
  for (std::size_t c = 0; c < column_count; ++c) copy.columns[c].resize(atoms.size());
}

}  // namespace

MapCopy copyMap(const Mapper& mapper) {
  MapCopy copy;
  copy.parameters = mapper.parameters();
  const std::size_t column_count = copy.parameters.mode == Mode::kOccupancy ? 4 : 5;
  const std::size_t expected = kGrowth + mapper.read([](const AtomMap& map) { return map.atoms().size(); });
  for (std::size_t c = 0; c < column_count; ++c) copy.columns[c].resize(expected);
  mapper.readBetweenScans([&](const AtomMap& map, std::uint64_t scans) {
    copy.scans = scans;
    copy.origin = map.origin();
    copyAtoms(map.atoms(), column_count, copy);
  });
  return copy;
}

}  // namespace atom_map
