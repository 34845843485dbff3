// Where the implicit function is exactly zero at nodes of the lattice, as in maps that lie in mirror image about them.
#include <gtest/gtest.h>

#include <array>

#include "atom_mapping/surface/extract_surface.h"

namespace atom_map {
namespace {

using Eigen::Vector3f;

class ZeroAtNodes : public testing::TestWithParam<std::tuple<Mode, int>> {};

// Free atoms above the plane z = `height` (m), as many occupied ones below; a lattice plane of the surface's is z = 0.
double areaOf(Mode mode, int half, float height) {
  constexpr float kRadius = 0.25F;
  AtomMap map(mode, kRadius);
  for (int x = -half; x <= half; ++x) {
    for (int y = -half; y <= half; ++y) {
      for (const float side : {-1.0F, 1.0F}) {
        const bool is_occupancy = mode == Mode::kOccupancy;
        const std::array<float, 2> values{is_occupancy ? -side : side * kRadius, 0.01F};
        const float across = 2.0F * kRadius;
        map.atoms().insert({across * static_cast<float>(x), across * static_cast<float>(y), height + side * kRadius},
                           values.data());
      }
    }
  }
  MappingParameters parameters;
  parameters.mode = mode;
  parameters.radius = kRadius;
  parameters.surface.occupancy_deviation = parameters.surface.distance_deviation = 1e6;  // nothing is left out
  const SurfaceMesh mesh = extractSurface(map, parameters, {});
  double area = 0.0;
  for (const auto& triangle : mesh.triangles) {
    const Vector3f a = mesh.vertices[triangle[0]].cast<float>();
    const Vector3f b = mesh.vertices[triangle[1]].cast<float>();
    const Vector3f c = mesh.vertices[triangle[2]].cast<float>();
    area += 0.5 * static_cast<double>((b - a).cross(c - a).norm());
  }
  return area;
}

TEST_P(ZeroAtNodes, LosesNoSurface) {
  const auto [mode, half] = GetParam();
  const double beside = areaOf(mode, half, 0.0007F);
  ASSERT_GT(beside, 0.0);
  EXPECT_GT(areaOf(mode, half, 0.0F), 0.7 * beside) << "of " << beside;
}

INSTANTIATE_TEST_SUITE_P(Maps, ZeroAtNodes,
                         testing::Combine(testing::Values(Mode::kOccupancy, Mode::kSignedDistance),
                                          testing::Values(0, 1, 8)));

}  // namespace
}  // namespace atom_map
