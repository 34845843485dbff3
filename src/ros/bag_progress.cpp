#include "atom_mapping/ros/bag_progress.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace atom_mapping {
namespace {

constexpr std::chrono::milliseconds kRedraw(100);
constexpr std::size_t kBarWidth = 30;

std::string describeTime(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  std::ostringstream text;
  text << std::setfill('0');
  if (whole >= 3600) text << whole / 3600 << ":" << std::setw(2);
  text << whole / 60 % 60 << ":" << std::setw(2) << whole % 60;
  return text.str();
}

}  // namespace

std::string describeProgress(std::size_t done, std::size_t total, double seconds) {
  std::ostringstream text;
  text << std::setw(3) << 100 * done / total << " %  " << done << " of " << total << " scans";
  if (done == total) {
    text << " in " << describeTime(seconds);
  } else if (done > 0) {
    text << ", " << describeTime(seconds / static_cast<double>(done) * static_cast<double>(total - done)) << " left";
  }
  return text.str();
}

BagProgress::BagProgress(std::size_t total, std::ostream& out, bool is_terminal)
    : total_(total), out_(out), is_terminal_(is_terminal) {}

BagProgress::~BagProgress() {
  if (is_terminal_ && done_ > 0) out_ << std::endl;
}

void BagProgress::step() {
  ++done_;
  const Clock::time_point now = Clock::now();
  const std::string text = describeProgress(done_, total_, std::chrono::duration<double>(now - start_).count());
  if (is_terminal_ && (now - drawn_ >= kRedraw || done_ == total_)) {
    drawn_ = now;
    drawBar(text);
  }
  const bool is_new_tenth = 10 * done_ / total_ != 10 * (done_ - 1) / total_;
  if (!is_terminal_ && is_new_tenth) out_ << text << std::endl;
}

void BagProgress::drawBar(const std::string& text) {
  const std::size_t filled = kBarWidth * done_ / total_;
  constexpr auto kEraseToEnd = "\x1b[K";
  out_ << "\r[" << std::string(filled, '#') << std::string(kBarWidth - filled, '.') << "] " << text << kEraseToEnd
       << std::flush;
}

}  // namespace atom_mapping
