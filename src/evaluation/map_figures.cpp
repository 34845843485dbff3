#include "atom_mapping/evaluation/map_figures.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "atom_mapping/io/write_file.h"

namespace atom_map {

nlohmann::ordered_json toJson(const MapFigures& figures) {
  const double per_scan = 1e3 / static_cast<double>(std::max<std::uint64_t>(figures.scans, 1));
  const ScanReport::Seconds& stages = figures.stages;
  const Spread& time = figures.milliseconds;
  nlohmann::ordered_json json{{"name", figures.name},
                              {"ms_per_scan", {{"mean", time.mean}, {"median", time.median}, {"p95", time.p95}}},
                              {"cpu_ms_per_scan", figures.cpu_milliseconds},
                              {"stages",
                               {{"filter", per_scan * stages.filter},
                                {"normals", per_scan * stages.normals},
                                {"rays", per_scan * stages.rays},
                                {"candidate_filter", per_scan * stages.candidate_filter},
                                {"merge", per_scan * stages.merge},
                                {"forget", per_scan * stages.forget}}},
                              {"bytes", figures.bytes},
                              {"units", figures.units},
                              {"free", figures.coverage.free.value()},
                              {"false_occupied", figures.coverage.false_occupied.value()},
                              {"unknown", figures.coverage.unknown.value()},
                              {"surface", figures.coverage.surface.value()}};
  if (figures.coverage.thin.whole > 0) json["thin"] = figures.coverage.thin.value();
  return json;
}

std::string toTable(const std::vector<MapFigures>& maps) {
  std::ostringstream out;
  const bool any_thin =
      std::any_of(maps.begin(), maps.end(), [](const auto& map) { return map.coverage.thin.whole > 0; });
  out << "map                         ms  median    95 %  cpu ms     bytes   units  B/unit    free  occupied  unknown  "
      << "surface" << (any_thin ? "    thin" : "") << "\n"
      << std::fixed;
  for (const MapFigures& map : maps) {
    const double bytes_per_unit =
        static_cast<double>(map.bytes) / static_cast<double>(std::max<std::uint64_t>(map.units, 1));
    out << std::left << std::setw(22) << map.name << std::right << std::setprecision(2);
    for (const double time :
         {map.milliseconds.mean, map.milliseconds.median, map.milliseconds.p95, map.cpu_milliseconds})
      out << std::setw(8) << time;
    out << std::setw(10) << map.bytes << std::setw(8) << map.units << std::setw(8) << std::setprecision(1)
        << bytes_per_unit << std::setprecision(4) << std::setw(8) << map.coverage.free.value() << std::setw(10)
        << map.coverage.false_occupied.value() << std::setw(9) << map.coverage.unknown.value() << std::setw(9)
        << map.coverage.surface.value();
    if (any_thin) out << std::setw(8) << map.coverage.thin.value();
    out << "\n";
  }
  return out.str();
}

void writeFigures(const nlohmann::ordered_json& all, const std::string& file) {
  writeFile(file, [&](std::ostream& out) { out << (all.size() == 1 ? all.front() : all).dump(2) << "\n"; });
}

}  // namespace atom_map
