#pragma once

#include <vector>

namespace atom_map {

// How bright to draw each vertex, 0.15 to 1: dark where the surface is sure, as in the paper's Fig. 4. By the variance's
// place between the smallest and the one that 95 % do not exceed.
std::vector<float> brightnessOf(const std::vector<float>& variance);

}  // namespace atom_map
