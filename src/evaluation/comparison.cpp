#include "atom_mapping/evaluation/comparison.h"

#include <algorithm>
#include <ctime>

#include "atom_mapping/base/timed.h"
#include "atom_mapping/evaluation/heap_in_use.h"

namespace atom_map {
namespace {

constexpr std::uint64_t kSampleSeed = 7;  // of the points that the maps are asked for

void add(const ScanReport::Seconds& more, ScanReport::Seconds& sum) {
  sum.filter += more.filter;
  sum.normals += more.normals;
  sum.rays += more.rays;
  sum.candidate_filter += more.candidate_filter;
  sum.merge += more.merge;
  sum.forget += more.forget;
}

}  // namespace

Comparison::Comparison(std::vector<ComparedMap> maps, std::size_t turn) : turn_(turn) {
  for (ComparedMap& map : maps) {
    Entry& entry = entries_.emplace_back();
    entry.map = std::move(map);
    entry.thread = std::make_unique<OwnThread>();
  }
}

void Comparison::insertScan(const LidarScan& scan, const Pose& sensor) {
  waiting_.push_back({scan, sensor});
  ++scans_;
  if (waiting_.size() >= turn_) insertWaiting();
}

void Comparison::insertWaiting() {
  if (waiting_.empty()) return;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    Entry& entry = entries_[(turns_ + i) % entries_.size()];
    entry.thread->run([&] {
      for (const Scan& scan : waiting_) insertTimed(scan, entry);
    });
  }
  waiting_.clear();
  ++turns_;
}

void Comparison::insertTimed(const Scan& scan, Entry& entry) {
  double seconds = 0.0;
  const std::clock_t start = std::clock();
  const ScanReport report = timed(seconds, [&] { return entry.map.insert_scan(scan.scan, scan.sensor); });
  entry.figures.cpu_milliseconds += 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  entry.milliseconds.push_back(1e3 * seconds);
  add(report.seconds, entry.figures.stages);
}

std::vector<const ComparedMap*> Comparison::maps() {
  insertWaiting();
  std::vector<const ComparedMap*> maps;
  for (const Entry& entry : entries_) maps.push_back(&entry.map);
  return maps;
}

std::vector<MapFigures> Comparison::finish(const std::vector<ObservedRay>& rays, double radius,
                                           const AskTrueDistance& true_distance) {
  insertWaiting();
  std::vector<MapFigures> all;
  for (Entry& entry : entries_) {
    MapFigures& figures = all.emplace_back(entry.figures);
    figures.name = entry.map.name;
    figures.milliseconds = spreadOf(entry.milliseconds);
    figures.scans = scans_;
    figures.cpu_milliseconds /= static_cast<double>(std::max<std::size_t>(scans_, 1));
    figures.coverage = measureCoverage(rays, radius, entry.map.ask, true_distance, kSampleSeed);
    figures.units = entry.map.units();
    figures.bytes = heapReleasedBy(entry.map.release);
  }
  return all;
}

}  // namespace atom_map
