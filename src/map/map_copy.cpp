#include "atom_mapping/map/map_copy.h"

#include <algorithm>

namespace atom_map {
namespace {

// Memory is made ready, page by page, before the map is held: that takes longer than to copy.
constexpr std::size_t kGrowth = 50000;  // atoms that may come meanwhile

std::size_t columnsOf(Mode mode) {
  return mode == Mode::kOccupancy ? 4 : 5;
}

void copyAtoms(const AtomTree& atoms, std::size_t column_count, MapCopy& copy) {
  for (std::size_t c = 0; c < column_count; ++c) copy.columns[c].resize(std::max(copy.size(), atoms.size()));
  std::array<float*, 5> at{};
  for (std::size_t c = 0; c < column_count; ++c) at[c] = copy.columns[c].data();
  atoms.forEachBlock([&](const AtomBlock& block) {
    for (std::size_t c = 0; c < column_count; ++c) {
      at[c] = std::copy_n(block.channel(static_cast<int>(c)), block.size(), at[c]);
    }
  });
  for (std::size_t c = 0; c < copy.columns.size(); ++c) copy.columns[c].resize(c < column_count ? atoms.size() : 0);
}

}  // namespace

MapCopy copyMap(const Mapper& mapper) {
  MapCopy copy;
  const std::size_t expected = kGrowth + mapper.read([](const AtomMap& map) { return map.atoms().size(); });
  const std::size_t likely = columnsOf(mapper.parameters().mode);
  for (std::size_t c = 0; c < likely; ++c) copy.columns[c].resize(expected);
  mapper.readBetweenScans([&](const AtomMap& map, std::uint64_t scans) {
    copy.parameters = mapper.parameters();
    copy.scans = scans;
    copy.origin = map.origin();
    copy.planes = map.planes();
    copyAtoms(map.atoms(), columnsOf(map.mode()), copy);
  });
  return copy;
}

}  // namespace atom_map
