// Maps merge by the rules of scans (paper III-E), and where only one has atoms they stay as they are.
#include <algorithm>
#include <utility>

#include "atom_mapping/query/combine_maps.h"
#include "atom_mapping/scan/snap.h"
#include "check_map.h"
#include "combine_maps_seeds.h"
#include "list_merge.h"
#include "map_file_folder.h"

namespace atom_map {
namespace {

AtomMap mapOf(const SortedAtoms& atoms) {
  AtomMap map(Mode::kOccupancy, double{kRadius});
  for (const auto& atom : atoms) map.atoms().insert({atom[0], atom[1], atom[2]}, &atom[3]);
  return map;
}

SortedAtoms drawAtoms(Random& random, const OccupancyParameters& parameters) {
  ListMerge list(parameters);
  for (int i = 0; i < 3; ++i) {
    Scan scan = drawScan(random, 3.0F);
    snapToLattice(scan.occupied, kRadius);
    snapToLattice(scan.free, kRadius);
    list.add(scan);
  }
  return list.atoms();
}

TEST_P(CombineMaps, WhereOnlyOneMapHasAtomsTheyKeepWhatTheyStore) {
  for (const Mode mode : {Mode::kOccupancy, Mode::kSignedDistance}) {
    const MappingParameters parameters = parametersOf(mode);
    const AtomMap a = drawMap(parameters, 1000, GetParam());
    const AtomMap b = drawMap(parameters, 1000, GetParam() + 100);
    AtomMap merged = drawMap(parameters, 1000, GetParam());
    const MergeReport report = mergeInto(merged, b, parameters);
    EXPECT_EQ(merged.atoms().size(), a.atoms().size() + report.inserted);
    expectNoOverlap(merged);
    int alone = 0;
    for (const auto& [one, other] : {std::make_pair(&a, &b), std::make_pair(&b, &a)}) {
      one->atoms().forEach([&, other = other](const ConstAtomRef& atom) {
        if (other->atoms().anyWithin(atom.center(), 2.001F * a.radius())) return;
        const auto found = merged.atoms().nearest(atom.center(), 1e-3F * a.radius());
        ASSERT_TRUE(found);
        ++alone;
        EXPECT_EQ(found->values[0], atom.value());
        if (mode == Mode::kSignedDistance) {
          EXPECT_EQ(found->values[1], atom.value(1));
        }
      });
    }
    EXPECT_GT(alone, 200);
  }
}

TEST_P(CombineMaps, MergesByTheRulesOfScans) {
  const OccupancyParameters parameters;
  const SortedAtoms a = drawAtoms(random_, parameters);
  const SortedAtoms b = drawAtoms(random_, parameters);
  AtomMap merged = mapOf(a);
  const AtomMap other = mapOf(b);
  mergeInto(merged, other, MappingParameters());
  Scan a_scan;  // no two of them overlap: added to an empty list they stay as they are
  for (const auto& atom : a) a_scan.free.push_back({{atom[0], atom[1], atom[2]}, atom[3]});
  Scan b_scan;
  other.atoms().forEach([&](const ConstAtomRef& atom) {
    (atom.value() > 0.0F ? b_scan.occupied : b_scan.free).push_back({atom.center(), atom.value()});
  });
  ListMerge list(parameters);
  list.add(a_scan);
  list.add(b_scan);
  const SortedAtoms expected = list.atoms();
  SortedAtoms atoms;
  merged.atoms().forEach([&](const ConstAtomRef& atom) {
    atoms.push_back({atom.center().x(), atom.center().y(), atom.center().z(), atom.value()});
  });
  std::sort(atoms.begin(), atoms.end());
  ASSERT_EQ(atoms.size(), expected.size());
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    for (int c = 0; c < 3; ++c) ASSERT_EQ(atoms[i][c], expected[i][c]);
    ASSERT_NEAR(atoms[i][3], expected[i][3], 1e-4F);
  }
  expectNoOverlap(merged);
  expectWithinClamps(merged, parameters.max_log_odds);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CombineMaps, tenSeeds());

}  // namespace
}  // namespace atom_map
