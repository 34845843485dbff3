#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "atom_mapping/ros/bag_progress.h"
#include "atom_mapping/ros/bag_summary.h"

namespace atom_mapping {
namespace {

TEST(DescribeProgress, TimeLeftIsThatOfTheScansToCome) {
  EXPECT_EQ(describeProgress(0, 1000, 1.0), "  0 %  0 of 1000 scans");
  EXPECT_EQ(describeProgress(420, 1000, 60.0), " 42 %  420 of 1000 scans, 1:23 left");
  EXPECT_EQ(describeProgress(1, 100, 75.0), "  1 %  1 of 100 scans, 2:03:45 left");
  EXPECT_EQ(describeProgress(1000, 1000, 59.7), "100 %  1000 of 1000 scans in 1:00");
}

std::string progressOf(std::size_t total, bool is_terminal) {
  std::ostringstream out;
  BagProgress progress(total, out, is_terminal);
  for (std::size_t i = 0; i < total; ++i) progress.step();
  return out.str();
}

TEST(BagProgress, ALogGetsALineEveryTenth) {
  const std::string log = progressOf(1000, false);
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 10);
  EXPECT_EQ(log.find_first_of("\r\x1b"), std::string::npos);
  EXPECT_EQ(log.rfind(" 10 %  100 of 1000 scans, ", 0), 0U);
  const std::string few = progressOf(3, false);
  EXPECT_EQ(std::count(few.begin(), few.end(), '\n'), 3);
}

TEST(BagProgress, ATerminalGetsABarOnOneLine) {
  const std::string bar = progressOf(1000, true);
  EXPECT_EQ(std::count(bar.begin(), bar.end(), '\n'), 0);
  EXPECT_EQ(bar.substr(0, 2), "\r[");
  EXPECT_NE(bar.find("[##############################] 100 %  1000 of 1000 scans"), std::string::npos);
}

ScanOutcome mapped(std::uint32_t points, float seconds) {
  ScanOutcome outcome;
  outcome.report.points_in = points;
  outcome.report.surface_points = points;
  outcome.report.atoms = 10;
  outcome.report.map_bytes = 255;
  outcome.report.seconds_total = seconds;
  return outcome;
}

TEST(BagSummary, AddsUpScansPointsAndDropsByCause) {
  BagSummary summary;
  summary.add(mapped(100, 0.010F));
  summary.add({Drop::kNoTransform, "no transform: first", {}});
  summary.add({Drop::kMalformed, "malformed: second", {}});
  summary.add({Drop::kNoTransform, "no transform: third", {}});
  summary.add(mapped(200, 0.030F));
  std::ostringstream out;
  summary.print(1.0, out);
  for (const char* line :
       {"scans mapped      2 in 1.0 s", "scans dropped     3, malformed 1, no transform 2\n",
        "  the first       no transform: first\n", "points            300, used 300\n", "atoms             10\n",
        "bytes             255, 25.5 an atom\n", "  total              20.00   30.00\n"}) {
    EXPECT_NE(out.str().find(line), std::string::npos) << line << "is not in\n" << out.str();
  }
  EXPECT_EQ(summary.mapped(), 2U);
  EXPECT_EQ(summary.firstDrop(), "no transform: first");
}

TEST(BagSummary, ARecordingWhoseTimeBeganAnewIsAsLongAsItsParts) {
  BagSummary summary;
  for (const double stamp : {100.0, 112.0, 50.0, 58.0}) {
    ScanOutcome outcome = mapped(100, 0.01F);
    outcome.report.header.stamp = ros::Time(stamp);
    summary.add(outcome);
  }
  std::ostringstream out;
  summary.print(2.0, out);
  EXPECT_NE(out.str().find("4 in 2.0 s, 10.0 times as fast as recorded\n"), std::string::npos) << out.str();
}

TEST(BagSummary, TellsWhatALimitedMapRefusedAndForgot) {
  BagSummary summary;
  ScanOutcome outcome = mapped(100, 0.01F);
  outcome.report.atoms_refused = 3;
  outcome.report.atoms_forgotten = 20;
  summary.add(outcome);
  summary.add(outcome);
  std::ostringstream out;
  summary.print(1.0, out);
  EXPECT_NE(out.str().find("atoms             10, refused 6, forgotten 40\n"), std::string::npos) << out.str();
}

TEST(BagSummary, OfNoScanIsShort) {
  std::ostringstream out;
  BagSummary().print(1.0, out);
  EXPECT_EQ(out.str(), "scans mapped      0 in 1.0 s\nscans dropped     0\n");
}

}  // namespace
}  // namespace atom_mapping
