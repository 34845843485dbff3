#include "atom_mapping/scan/snap.h"

#include <gtest/gtest.h>

#include "atom_mapping/base/types.h"
#include "draw.h"

namespace atom_map {
namespace {

TEST(Snap, CentresMoveByLessThanAThousandthOfARadiusOntoMultiplesOfAPowerOfTwo) {
  Random random(1);
  for (const float radius : {0.01F, 0.1F, 0.25F, 0.3F, 1.0F, 100.0F}) {
    const float spacing = latticeSpacing(radius);
    int exponent = 0;
    EXPECT_EQ(std::frexp(spacing, &exponent), 0.5F);
    EXPECT_LE(spacing, radius / 1024.0F);
    EXPECT_GT(spacing, radius / 2049.0F);
    std::vector<Candidate> candidates;
    for (int i = 0; i < 1000; ++i) candidates.push_back({drawWithin(random, 1000.0F * radius), 1.0F});
    std::vector<Candidate> snapped = candidates;
    snapToLattice(snapped, radius);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Eigen::Vector3f& center = snapped[i].center;
      EXPECT_LE((center - candidates[i].center).norm(), 0.87F * spacing);
      EXPECT_EQ(Eigen::Vector3f((center / spacing).array().round()), Eigen::Vector3f(center / spacing));
    }
    const std::vector<Candidate> once = snapped;
    snapToLattice(snapped, radius);
    for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(snapped[i].center, once[i].center);
  }
}

}  // namespace
}  // namespace atom_map
