#include "atom_mapping/evaluation/judge_quality.h"

#include <nlohmann/json.hpp>
#include <string>

#include "atom_mapping/evaluation/surface_quality.h"

namespace atom_map {
namespace {

constexpr std::uint64_t kSampleSeed = 7;  // of the points that the maps are asked for

bool isClosed(const Scene& scene) {
  return scene.name() == "cube" || scene.name() == "cube_rotated" || scene.name() == "sphere";
}

void add(const std::string& name, const std::vector<Share>& shares, nlohmann::ordered_json& json) {
  for (const Share& share : shares) {
    const bool is_known = share.whole > 0;  // no point is so near
    json[name].push_back(is_known ? nlohmann::ordered_json(share.value()) : nullptr);
    json[name + "_error"].push_back(is_known ? nlohmann::ordered_json(standardError(share)) : nullptr);
  }
}

}  // namespace

std::vector<double> judgedDistances(const Scene& scene, double radius) {
  return isClosed(scene) ? distancesFromSurface(radius) : std::vector<double>{0.05, 0.1, 0.25, 0.5};
}

nlohmann::ordered_json judgeQuality(const Scene& scene, const RecordedDrive& drive, double radius,
                                    const ComparedMap& map) {
  const std::vector<double> epsilon = judgedDistances(scene, radius);
  const bool closed = isClosed(scene);
  const SurfaceQuality quality = closed ? measureSurfaceQuality(scene, epsilon, map.ask, kSampleSeed)
                                        : measureQualityAtReturns(scene, drive.rays, epsilon, map.ask, kSampleSeed);
  nlohmann::ordered_json json;
  add(closed ? "Q" : "near_free", quality.q, json);
  add(closed ? "F" : "near_false_free", quality.f, json);
  return json;
}

}  // namespace atom_map
