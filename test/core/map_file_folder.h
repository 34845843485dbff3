// What the tests of the map file share: maps of atoms anywhere, and a folder of their own for files.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "../test_folder.h"
#include "atom_mapping/io/map_file.h"
#include "draw.h"

namespace atom_map {

inline MappingParameters parametersOf(Mode mode, double radius = 0.25) {
  MappingParameters parameters;
  parameters.mode = mode;
  parameters.radius = radius;
  parameters.occupancy.max_log_odds = 3.5;  // drawMap's
  return parameters;
}

// Up to `count` atoms, no two nearer than they may be, 100 km from the map frame's origin.
inline AtomMap drawMap(const MappingParameters& parameters, int count, std::uint64_t seed) {
  AtomMap map(parameters.mode, parameters.radius);
  map.anchor({1e5, -1e5, 37.0});
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3f center = drawIn(random, {Eigen::Vector3f(-20, -15, -1), Eigen::Vector3f(20, 15, 3)});
    if (map.atoms().nearest(center, 2.0F * map.radius())) continue;
    const bool is_clamped = random.uniform() < 0.2F;
    const float value = is_clamped ? -3.5F : draw(random, -3.5F, 3.5F);
    const float values[] = {value, random.uniform()};
    map.atoms().insert(center, values);
  }
  for (int i = 0; i < count / 10; ++i) {
    map.planes().push_back({drawWithin(random, 20.0F), drawDirection(random), draw(random, -20.0F, 20.0F),
                            3.0F + static_cast<float>(i % 14)});
  }
  return map;
}

// All that is told of planes, in order.
inline std::vector<float> numbersOf(const std::vector<KnownPlane>& planes) {
  std::vector<float> numbers;
  for (const auto& [place, normal, level, fits] : planes) {
    for (const Eigen::Vector3f& vector : {place, normal}) numbers.insert(numbers.end(), vector.begin(), vector.end());
    numbers.insert(numbers.end(), {level, fits});
  }
  return numbers;
}

inline MapCopy copyOf(const MappingParameters& parameters, AtomMap map, std::uint64_t scans = 7) {
  Mapper mapper(parameters);
  mapper.replace(std::move(map), scans);
  return copyMap(mapper);
}

// What loadMap says against a file; empty if nothing.
inline std::string faultOf(const std::string& file) {
  try {
    loadMap(file);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

class MapFile : public FolderTest {
 protected:
  std::string write(const std::string& bytes) const {
    std::ofstream(path("written.h5"), std::ios::binary) << bytes;
    return path("written.h5");
  }

  void expectRefused(const std::string& file, const std::string& reason) const {
    const std::string fault = faultOf(file);
    EXPECT_EQ(fault.rfind("cannot load " + file + ": ", 0), 0U) << fault;
    EXPECT_NE(fault.find(reason), std::string::npos) << "expected: " << reason << "\n" << fault;
  }
};

}  // namespace atom_map
