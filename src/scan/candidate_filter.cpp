#include "atom_mapping/scan/candidate_filter.h"

#include "atom_mapping/base/cell_table.h"

namespace atom_map {
namespace {

// The first candidate of each cell that none was taken from yet.
template <class AnyCandidate>
std::vector<AnyCandidate> firstOfEachCell(const std::vector<AnyCandidate>& candidates, CellTable<bool>& taken) {
  std::vector<AnyCandidate> kept;
  for (const AnyCandidate& candidate : candidates) {
    bool& cell = taken.at(candidate.center);
    if (!cell) kept.push_back(candidate);
    cell = true;
  }
  return kept;
}

}  // namespace

Candidates filterCandidates(const Candidates& candidates, float cell_size) {
  CellTable<bool> taken(cell_size, candidates.size());
  Candidates kept;
  kept.proposed = candidates.proposed;
  kept.occupied = firstOfEachCell(candidates.occupied, taken);
  kept.free = firstOfEachCell(candidates.free, taken);
  return kept;
}

DistanceCandidates filterCandidates(const DistanceCandidates& candidates, float cell_size) {
  CellTable<bool> taken(cell_size, candidates.size());
  DistanceCandidates kept;
  kept.proposed = candidates.proposed;
  kept.behind = firstOfEachCell(candidates.behind, taken);
  kept.infront = firstOfEachCell(candidates.infront, taken);
  return kept;
}

}  // namespace atom_map
