#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace atom_map {

// The least of the values that a share of them, above 0 and up to 1, do not exceed. Reorders the values, of which there
// must be one at least.
template <class Number>
Number quantile(std::vector<Number>& values, double share) {
  assert(!values.empty() && share > 0.0 && share <= 1.0);
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size())));
  const auto place = values.begin() + (rank - 1);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace atom_map
