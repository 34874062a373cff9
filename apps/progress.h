// Progress of a long computation, with the time that is left at most.  On a terminal one line is updated in place;
// elsewhere, such as in a log file, a new line is printed from time to time.
#pragma once

#include <chrono>
#include <string>

namespace ease {

class Progress {
 public:
  /// Starts to report on at most `total` units of work; prints on standard error.
  explicit Progress(long total);
  ~Progress();  // ends the line

  /// Counts one unit of work as done; `what` describes the work on the line.
  void advance(const std::string& what);

 private:
  using Clock = std::chrono::steady_clock;
  long total_, done_ = 0;
  bool terminal_;
  bool line_open_ = false;
  Clock::time_point start_, last_;
};

/// Formats a duration for people, for example "1 min 20 s".
std::string durationText(double seconds);

}  // namespace ease
