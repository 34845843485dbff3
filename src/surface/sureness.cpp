#include "atom_mapping/surface/sureness.h"

#include <algorithm>

namespace atom_map {

std::vector<float> brightnessOf(const std::vector<float>& variance) {
  if (variance.empty()) return {};
  std::vector<float> sorted = variance;
  std::sort(sorted.begin(), sorted.end());
  const float low = sorted.front();
  const float span = std::max(sorted[(sorted.size() - 1) * 95 / 100] - low, 1e-9F);
  std::vector<float> brightness(variance.size());
  std::transform(variance.begin(), variance.end(), brightness.begin(),
                 [&](float v) { return 0.15F + 0.85F * std::min((v - low) / span, 1.0F); });
  return brightness;
}

}  // namespace atom_map
