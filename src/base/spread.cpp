#include "atom_mapping/base/spread.h"

#include <numeric>

#include "atom_mapping/base/quantile.h"

namespace atom_map {

Spread spreadOf(std::vector<double> values) {
  if (values.empty()) return {};
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return {sum / static_cast<double>(values.size()), quantile(values, 0.5), quantile(values, 0.95)};
}

}  // namespace atom_map
