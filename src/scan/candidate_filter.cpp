#include "atom_mapping/scan/candidate_filter.h"

#include "atom_mapping/base/cell_table.h"

namespace atom_map {

Candidates filterCandidates(const Candidates& candidates, float cell_size) {
  CellTable<bool> taken(cell_size, candidates.size());
  const auto firstOfEachCell = [&](const std::vector<Candidate>& all) {
    std::vector<Candidate> kept;
    for (const Candidate& candidate : all) {
      bool& cell = taken.at(candidate.center);
      if (!cell) kept.push_back(candidate);
      cell = true;
    }
    return kept;
  };
  Candidates kept;
  kept.proposed = candidates.proposed;
  kept.occupied = firstOfEachCell(candidates.occupied);
  kept.free = firstOfEachCell(candidates.free);
  return kept;
}

}  // namespace atom_map
