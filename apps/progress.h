// Progress of long work: one line that renews itself with the time left on a terminal, a line now and then elsewhere.
#pragma once

#include <chrono>
#include <string>

namespace ease {

class Progress {
 public:
  /// `total` units of work; writes to standard error.
  explicit Progress(long total);
  ~Progress();  // ends the line

  void advance(const std::string& what);

 private:
  using Clock = std::chrono::steady_clock;
  long total_, done_ = 0;
  bool terminal_;
  bool line_open_ = false;
  Clock::time_point start_, last_;
};

/// "1 min 20 s"
std::string durationText(double seconds);

}  // namespace ease
