#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <string>

namespace atom_mapping {

// As CLI::Range, which lets NaN through.
inline CLI::Validator finiteRange(double low, double high) {
  const auto check = [](const std::string& text) {
    return std::string(std::isnan(std::strtod(text.c_str(), nullptr)) ? "is not a number" : "");
  };
  return CLI::Validator(check, "") & CLI::Range(low, high);
}

}  // namespace atom_mapping
