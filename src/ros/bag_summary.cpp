#include "atom_mapping/ros/bag_summary.h"

#include <algorithm>
#include <iomanip>
#include <numeric>
#include <utility>

#include "atom_mapping/base/spread.h"

namespace atom_mapping {
namespace {

using Count = std::uint32_t ScanReport::*;
using Seconds = float ScanReport::*;

std::uint64_t sum(const std::vector<ScanReport>& reports, Count count) {
  return std::accumulate(reports.begin(), reports.end(), std::uint64_t{0},
                         [&](std::uint64_t total, const ScanReport& report) { return total + report.*count; });
}

// Seconds from scan to scan, where time did not begin anew.
double secondsOf(const std::vector<ScanReport>& reports) {
  double seconds = 0.0;
  for (std::size_t i = 1; i < reports.size(); ++i) {
    seconds += std::max(0.0, (reports[i].header.stamp - reports[i - 1].header.stamp).toSec());
  }
  return seconds;
}

std::ostream& label(std::ostream& out, const char* text) {
  return out << std::left << std::setw(18) << text << std::right;
}

}  // namespace

void BagSummary::add(const ScanOutcome& outcome) {
  if (!outcome.drop) {
    reports_.push_back(outcome.report);
    return;
  }
  ++drops_[*outcome.drop];
  if (first_drop_.empty()) first_drop_ = outcome.message;
}

void BagSummary::print(double seconds, std::ostream& out) const {
  out << std::fixed;
  printScans(seconds, out);
  if (reports_.empty()) return;
  printPoints(out);
  printMap(out);
  printTimes(out);
}

void BagSummary::printScans(double seconds, std::ostream& out) const {
  label(out, "scans mapped") << reports_.size() << " in " << std::setprecision(1) << seconds << " s";
  if (reports_.size() > 1) {
    out << ", " << secondsOf(reports_) / seconds << " times as fast as recorded";
  }
  out << "\n";
  label(out, "scans dropped") << std::accumulate(drops_.begin(), drops_.end(), std::size_t{0},
                                                 [](std::size_t total, const auto& d) { return total + d.second; });
  for (const auto& [cause, count] : drops_) out << ", " << toString(cause) << " " << count;
  out << "\n";
  if (!first_drop_.empty()) label(out, "  the first") << first_drop_ << "\n";
}

void BagSummary::printPoints(std::ostream& out) const {
  label(out, "points") << sum(reports_, &ScanReport::points_in);
  out << ", used " << sum(reports_, &ScanReport::surface_points);
  for (const auto& [name, count] : {std::pair<const char*, Count>{"thinned", &ScanReport::dropped_thinned},
                                    {"too far", &ScanReport::dropped_too_far},
                                    {"too near", &ScanReport::dropped_too_near},
                                    {"no return", &ScanReport::dropped_no_return},
                                    {"not a number", &ScanReport::dropped_nan},
                                    {"without a normal", &ScanReport::normals_fallback}}) {
    if (const std::uint64_t points = sum(reports_, count); points > 0) out << ", " << name << " " << points;
  }
  out << "\n";
}

void BagSummary::printMap(std::ostream& out) const {
  const ScanReport& last = reports_.back();
  label(out, "atoms") << last.atoms;
  for (const auto& [name, count] : {std::pair<const char*, Count>{"refused", &ScanReport::atoms_refused},
                                    {"forgotten", &ScanReport::atoms_forgotten}}) {
    if (const std::uint64_t atoms = sum(reports_, count); atoms > 0) out << ", " << name << " " << atoms;
  }
  out << "\n";
  label(out, "bytes") << last.map_bytes;
  if (last.atoms > 0) {
    out << ", " << static_cast<double>(last.map_bytes) / static_cast<double>(last.atoms) << " an atom";
  }
  out << "\n";
}

void BagSummary::printTimes(std::ostream& out) const {
  label(out, "ms a scan") << "    mean    95 %\n";
  for (const auto& [name, stage] : {std::pair<const char*, Seconds>{"  filter", &ScanReport::seconds_filter},
                                    {"  normals", &ScanReport::seconds_normals},
                                    {"  rays", &ScanReport::seconds_rays},
                                    {"  candidate filter", &ScanReport::seconds_candidate_filter},
                                    {"  merge", &ScanReport::seconds_merge},
                                    {"  forget", &ScanReport::seconds_forget},
                                    {"  total", &ScanReport::seconds_total}}) {
    std::vector<double> times;
    for (const ScanReport& report : reports_) times.push_back(1e3 * static_cast<double>(report.*stage));
    const atom_map::Spread time = atom_map::spreadOf(times);
    label(out, name) << std::setprecision(2) << std::setw(8) << time.mean << std::setw(8) << time.p95 << "\n";
  }
}

}  // namespace atom_mapping
