#pragma once

namespace atom_map {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;  // radians

}  // namespace atom_map
