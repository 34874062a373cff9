#include "apps/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace ease {

std::string durationText(double seconds) {
  const long s = std::lround(seconds);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {} s", s / 60, s % 60);
  return fmt::format("{} h {} min", s / 3600, s / 60 % 60);
}

Progress::Progress(long total) : total_(total), terminal_(isatty(STDERR_FILENO)), start_(Clock::now()), last_(start_) {}

Progress::~Progress() {
  if (line_open_) std::fputc('\n', stderr);
}

void Progress::advance(const std::string& what) {
  ++done_;
  const auto now = Clock::now();
  const std::chrono::duration<double> since_last = now - last_, since_start = now - start_;
  if (since_last.count() < (terminal_ ? 0.2 : 20.0)) return;
  last_ = now;
  const double left = since_start.count() / static_cast<double>(done_) * static_cast<double>(total_ - done_);
  const std::string text =
      fmt::format("{:3.0f} %, {}, at most {} left", 100.0 * static_cast<double>(done_) / static_cast<double>(total_),
                  what, durationText(left));
  std::fputs((terminal_ ? "\r\033[K" + text : text + "\n").c_str(), stderr);
  std::fflush(stderr);
  line_open_ = terminal_;
}

}  // namespace ease
