#pragma once

#include <vector>

namespace atom_map {

// Of some values: their mean, and the least of them that half, that 95 % do not exceed. Zero without values.
struct Spread {
  double mean = 0.0;
  double median = 0.0;
  double p95 = 0.0;
};
Spread spreadOf(std::vector<double> values);

}  // namespace atom_map
