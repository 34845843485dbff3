#pragma once

#include <chrono>
#include <cstddef>
#include <ostream>
#include <string>

namespace atom_mapping {

// Such as " 42 %  420 of 1000 scans, 1:23 left"; `seconds` since the first. No scan done: the time left is unknown.
std::string describeProgress(std::size_t done, std::size_t total, double seconds);

// Tells how far a run over a bag is: by a bar that moves, or for a log by a line every tenth.
class BagProgress {
 public:
  BagProgress(std::size_t total, std::ostream& out, bool is_terminal);
  BagProgress(const BagProgress&) = delete;
  BagProgress& operator=(const BagProgress&) = delete;
  ~BagProgress();  // leaves the bar's line

  // One more scan is done.
  void step();

 private:
  using Clock = std::chrono::steady_clock;

  void drawBar(const std::string& text);

  std::size_t total_;
  std::ostream& out_;
  bool is_terminal_;
  std::size_t done_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_;
};

}  // namespace atom_mapping
