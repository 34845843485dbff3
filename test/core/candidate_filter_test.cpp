// Stage 5: one candidate a cell, and occupied ones before free ones.
#include "atom_mapping/scan/candidate_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "draw.h"
#include "reproducible.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;
using CellIndex = std::tuple<int, int, int>;

constexpr float kSide = 0.5F;

CellIndex cellOf(const Candidate& candidate) {
  const auto cell = [&](int axis) { return static_cast<int>(std::floor(candidate.center[axis] / kSide)); };
  return {cell(0), cell(1), cell(2)};
}

// Some of them on the cells' borders.
Candidates drawCandidates(std::uint64_t seed, int occupied, int free, float half) {
  Random random(seed);
  const auto drawMany = [&](int count, float value) {
    std::vector<Candidate> candidates;
    for (int i = 0; i < count; ++i) {
      Vector3f center = drawWithin(random, half);
      if (i % 5 == 0) center = kSide * (center / kSide).array().round();
      candidates.push_back({center, value});
    }
    return candidates;
  };
  Candidates candidates;
  candidates.occupied = drawMany(occupied, 0.8F);
  candidates.free = drawMany(free, -0.4F);
  candidates.proposed = 12345;
  return candidates;
}

// In any order.
bool isSame(std::vector<Candidate> a, std::vector<Candidate> b) {
  for (auto* candidates : {&a, &b}) {
    std::sort(candidates->begin(), candidates->end(),
              [](const Candidate& x, const Candidate& y) { return cellOf(x) < cellOf(y); });
  }
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Candidate& x, const Candidate& y) { return x.center == y.center && x.value == y.value; });
}

// As the header says it, candidate by candidate.
Candidates filterByHand(const Candidates& all) {
  std::map<CellIndex, bool> taken;
  Candidates kept;
  for (const Candidate& candidate : all.occupied) {
    if (!std::exchange(taken[cellOf(candidate)], true)) kept.occupied.push_back(candidate);
  }
  for (const Candidate& candidate : all.free) {
    if (!std::exchange(taken[cellOf(candidate)], true)) kept.free.push_back(candidate);
  }
  return kept;
}

RC_GTEST_PROP(CandidateFilter, KeepsTheFirstOfEachCellAndNoFreeOneBesideAnOccupiedOne, ()) {
  const auto half = *rc::gen::element(0.4F, 2.0F, 40.0F);
  const auto occupied = *rc::gen::inRange(0, 500);
  const auto free = *rc::gen::inRange(0, 500);
  const Candidates all = drawCandidates(*rc::gen::inRange<std::uint64_t>(0, 1000000), occupied, free, half);
  const Candidates kept = filterCandidates(all, kSide);
  const Candidates expected = filterByHand(all);
  RC_ASSERT(isSame(kept.occupied, expected.occupied));
  RC_ASSERT(isSame(kept.free, expected.free));
  RC_ASSERT(kept.proposed == all.proposed);
}

TEST(CandidateFilter, NoCellKeepsMoreThanOneAndNoOccupiedCellIsLost) {
  const Candidates all = drawCandidates(1, 3000, 9000, 4.0F);
  const Candidates kept = filterCandidates(all, kSide);
  std::map<CellIndex, int> cells;
  for (const Candidate& candidate : kept.occupied) ++cells[cellOf(candidate)];
  for (const Candidate& candidate : all.occupied) ASSERT_EQ(cells.count(cellOf(candidate)), 1U);
  for (const Candidate& candidate : kept.free) ++cells[cellOf(candidate)];
  for (const Candidate& candidate : all.free) ASSERT_EQ(cells.count(cellOf(candidate)), 1U) << "a cell is left out";
  for (const auto& [cell, count] : cells) ASSERT_EQ(count, 1);
}

TEST(CandidateFilter, IsIdempotent) {
  const Candidates once = filterCandidates(drawCandidates(2, 2000, 5000, 10.0F), kSide);
  const Candidates twice = filterCandidates(once, kSide);
  EXPECT_TRUE(isSame(once.occupied, twice.occupied));
  EXPECT_TRUE(isSame(once.free, twice.free));
}

TEST(CandidateFilter, NothingStaysNothing) {
  EXPECT_EQ(filterCandidates(Candidates{}, kSide).size(), 0U);
}

}  // namespace
}  // namespace atom_map
