#include "atom_mapping/ros/atom_colors.h"

#include <algorithm>
#include <array>

namespace atom_mapping {

std_msgs::ColorRGBA colorOf(float value) {
  using Rgb = std::array<float, 3>;
  static constexpr std::array<Rgb, 5> kStops{Rgb{0.19F, 0.25F, 0.65F},
                                             {0.10F, 0.60F, 0.75F},
                                             {0.35F, 0.75F, 0.35F},
                                             {0.95F, 0.80F, 0.25F},
                                             {0.80F, 0.20F, 0.15F}};
  constexpr float kLast = kStops.size() - 1;
  const float place = std::clamp(value, 0.0F, 1.0F) * kLast;
  const auto below = static_cast<std::size_t>(std::min(place, kLast - 1.0F));
  const float share = place - static_cast<float>(below);
  const auto mix = [&](std::size_t i) { return (1.0F - share) * kStops[below][i] + share * kStops[below + 1][i]; };
  std_msgs::ColorRGBA color;
  color.r = mix(0);
  color.g = mix(1);
  color.b = mix(2);
  color.a = 1.0F;
  return color;
}

}  // namespace atom_mapping
