#include "atom_mapping/scan/candidate_filter.h"

#include <utility>

#include "atom_mapping/base/cell_set.h"

namespace atom_map {
namespace {

constexpr std::size_t kCandidatesPerBlock = 8;  // about

// The first candidate of each cell that none was taken from yet, block by block.
template <class AnyCandidate>
std::vector<AnyCandidate> firstOfEachCell(const std::vector<AnyCandidate>& candidates, CellSet& taken) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> kept;  // block and place of each
  kept.reserve(candidates.size());
  taken.insertEach(
      candidates.size(), [&](std::size_t i) { return candidates[i].center; },
      [&](std::size_t i, std::uint32_t block) { kept.emplace_back(block, i); });
  std::vector<std::uint32_t> end(taken.blocks() + 1, 0);  // of a block, in the order that is made
  for (const auto& [block, place] : kept) ++end[block + 1];
  for (std::size_t block = 1; block < end.size(); ++block) end[block] += end[block - 1];
  std::vector<AnyCandidate> ordered(kept.size());
  for (const auto& [block, place] : kept) ordered[end[block]++] = candidates[place];
  return ordered;
}

}  // namespace

Candidates filterCandidates(const Candidates& candidates, float cell_size) {
  CellSet taken(cell_size, candidates.size() / kCandidatesPerBlock);
  Candidates kept;
  kept.proposed = candidates.proposed;
  kept.occupied = firstOfEachCell(candidates.occupied, taken);
  kept.free = firstOfEachCell(candidates.free, taken);
  return kept;
}

DistanceCandidates filterCandidates(const DistanceCandidates& candidates, float cell_size) {
  CellSet taken(cell_size, candidates.size() / kCandidatesPerBlock);
  DistanceCandidates kept;
  kept.proposed = candidates.proposed;
  kept.behind = firstOfEachCell(candidates.behind, taken);
  kept.infront = firstOfEachCell(candidates.infront, taken);
  return kept;
}

}  // namespace atom_map
