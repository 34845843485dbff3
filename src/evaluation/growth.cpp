#include "atom_mapping/evaluation/growth.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

namespace atom_map {
namespace {

GrowthStep mapCopy(const RecordedDrive& drive, const Eigen::Vector3d& place, Mapper& mapper) {
  GrowthStep step;
  std::vector<double> times;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    const std::clock_t start = std::clock();
    const ScanReport report = mapper.insertScan(drive.scans[i], Eigen::Translation3d(place) * drive.poses[i]);
    times.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    step.slowest = std::max(step.slowest, times.back());
    step.slowest_merging = std::max(step.slowest_merging, 1e3 * report.seconds.merge);
    step.atoms = report.atoms;
    step.bytes = report.map_bytes;
  }
  step.milliseconds = spreadOf(times);
  return step;
}

}  // namespace

Eigen::Vector3d placeOfCopy(std::size_t i, std::size_t copies, double spacing) {
  const auto row = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(copies))));
  const std::size_t line = i / row;
  return spacing * Eigen::Vector3d(static_cast<double>(i % row), static_cast<double>(line), 0.0);
}

std::vector<GrowthStep> growMap(const RecordedDrive& drive, double spacing, std::uint64_t least_atoms, Mapper& mapper,
                                const std::function<void(const GrowthStep&)>& report) {
  std::vector<GrowthStep> steps;
  std::size_t copies = 1;  // that it will take, known after the first
  while (steps.empty() || steps.back().atoms < least_atoms) {
    steps.push_back(mapCopy(drive, placeOfCopy(steps.size(), copies, spacing), mapper));
    if (steps.size() == 1) copies = 1 + least_atoms / std::max<std::uint64_t>(steps.front().atoms, 1);
    report(steps.back());
  }
  return steps;
}

nlohmann::ordered_json toJson(const GrowthStep& step) {
  return {{"atoms", step.atoms},
          {"bytes", step.bytes},
          {"cpu_ms_per_scan", step.milliseconds.mean},
          {"cpu_ms_p95", step.milliseconds.p95},
          {"cpu_ms_slowest", step.slowest},
          {"merge_ms_slowest", step.slowest_merging}};
}

}  // namespace atom_map
